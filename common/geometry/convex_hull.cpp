#include "geometry/convex_hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/convex_hull_3.h>

#include <map>

namespace ductus {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

// Far from one plane: the hull of coplanar points is a polygon, no surface of triangles around a volume.
bool isSolid(const std::vector<Point> &points)
{
    const auto differs = [&](std::size_t i) { return points[i] != points[0]; };
    std::size_t b = 1;
    while (b < points.size() && !differs(b))
        ++b;
    std::size_t c = b + 1;
    while (c < points.size() && CGAL::collinear(points[0], points[b], points[c]))
        ++c;
    std::size_t d = c + 1;
    while (d < points.size() && CGAL::coplanar(points[0], points[b], points[c], points[d]))
        ++d;
    return d < points.size();
}

} // namespace

std::vector<Triangle> convexHull(const std::vector<Vec3> &points)
{
    std::vector<Point> places;
    places.reserve(points.size());
    for (const Vec3 &p : points)
        places.emplace_back(p.x(), p.y(), p.z());
    if (!isSolid(places))
        return {};
    std::map<Point, int> indexOf; // the hull's corners are the points themselves, not near them
    for (std::size_t i = 0; i < places.size(); ++i)
        indexOf.emplace(places[i], int(i));
    CGAL::Surface_mesh<Point> hull;
    CGAL::convex_hull_3(places.begin(), places.end(), hull);
    std::vector<Triangle> triangles;
    for (const auto face : hull.faces()) {
        std::vector<int> corners;
        for (const auto vertex : CGAL::vertices_around_face(hull.halfedge(face), hull))
            corners.push_back(indexOf.at(hull.point(vertex)));
        for (std::size_t k = 2; k < corners.size(); ++k)
            triangles.push_back({corners[0], corners[k - 1], corners[k]});
    }
    return triangles;
}

} // namespace ductus
