#include "geometry/inspection/self_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace ductus {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

/// Do two different triangles of an indexed mesh meet elsewhere than in the corners and edges they share?
bool trianglesIntersect(const std::vector<Point> &points, const Triangle &s, const Triangle &t)
{
    std::array<int, 3> shared{};
    int sharedCount = 0;
    int freeOfS = -1, freeOfT = -1; // a corner of one that the other has not
    for (int k = 0; k < 3; ++k) {
        if (std::find(t.begin(), t.end(), s[k]) != t.end())
            shared[sharedCount++] = s[k];
        else
            freeOfS = k;
        if (std::find(s.begin(), s.end(), t[k]) == s.end())
            freeOfT = k;
    }
    const auto triangle = [&](const Triangle &c) {
        return Kernel::Triangle_3(points[c[0]], points[c[1]], points[c[2]]);
    };
    const auto sideAcross = [&](const Triangle &c, int corner) {
        const int k = int(std::find(c.begin(), c.end(), corner) - c.begin());
        return Kernel::Segment_3(points[c[(k + 1) % 3]], points[c[(k + 2) % 3]]);
    };
    switch (sharedCount) {
    case 0:
        return CGAL::do_intersect(triangle(s), triangle(t));
    case 1:
        return CGAL::do_intersect(sideAcross(s, shared[0]), triangle(t)) ||
               CGAL::do_intersect(sideAcross(t, shared[0]), triangle(s));
    case 2: {
        const Point &a = points[shared[0]], &b = points[shared[1]];
        const Point &c = points[s[freeOfS]], &d = points[t[freeOfT]];
        return CGAL::orientation(a, b, c, d) == CGAL::COPLANAR &&
               CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE; // folded onto each other
    }
    default:
        return true;
    }
}

struct Enough
{
};

} // namespace

std::vector<TrianglePair> selfIntersections(const TriangleMesh &mesh, int most)
{
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
    std::vector<Point> points;
    points.reserve(mesh.vertices.size());
    for (const Vec3 &v : mesh.vertices)
        points.emplace_back(v.x(), v.y(), v.z());
    std::vector<Box> boxes;
    boxes.reserve(mesh.triangles.size());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Triangle &c = mesh.triangles[t];
        boxes.emplace_back(points[c[0]].bbox() + points[c[1]].bbox() + points[c[2]].bbox(), t);
    }
    std::vector<TrianglePair> found;
    try {
        CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box &a, const Box &b) {
            if (!trianglesIntersect(points, mesh.triangles[a.info()], mesh.triangles[b.info()]))
                return;
            found.push_back({std::min(a.info(), b.info()), std::max(a.info(), b.info())});
            if (int(found.size()) >= most)
                throw Enough(); // the only way out of the search
        });
    } catch (const Enough &) {
    }
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace ductus
