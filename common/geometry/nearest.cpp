#include "geometry/nearest.h"

#include "base/assert.h"
#include "geometry/triangle_point.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ductus {

namespace {

// Exact predicates: the crossings of a ray are counted without rounding.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Point toPoint(const Vec3 &v)
{
    return {v.x(), v.y(), v.z()};
}

/// How the line from \a p towards \a q crosses triangle \a t.
enum class Crossing { None, Outwards, Inwards, Unclear };

Crossing crossing(const Point &p, const Point &q, const Kernel::Triangle_3 &t)
{
    const std::array<CGAL::Orientation, 3> sides{CGAL::orientation(p, q, t[0], t[1]),
                                                 CGAL::orientation(p, q, t[1], t[2]),
                                                 CGAL::orientation(p, q, t[2], t[0])};
    const bool anyLeft = std::count(sides.begin(), sides.end(), CGAL::POSITIVE) > 0;
    const bool anyRight = std::count(sides.begin(), sides.end(), CGAL::NEGATIVE) > 0;
    if (anyLeft && anyRight)
        return Crossing::None;
    if (std::count(sides.begin(), sides.end(), CGAL::COPLANAR) > 0)
        return Crossing::Unclear; // through an edge or a corner, or within the plane
    return anyLeft ? Crossing::Outwards : Crossing::Inwards;
}

/// Directions in general position; the next one is tried when a ray meets an edge or a corner exactly.
const std::array<Vec3, 7> rayDirections{Vec3{0.5374, 0.6261, 0.5649},   Vec3{-0.7123, 0.4217, 0.5611},
                                        Vec3{0.2897, -0.8311, 0.4747},  Vec3{-0.4519, -0.3733, 0.8101},
                                        Vec3{0.8923, 0.1319, -0.4315},  Vec3{-0.1733, 0.9241, -0.3407},
                                        Vec3{-0.6011, -0.5501, -0.5797}};

} // namespace

struct NearestOnMesh::Implementation
{
    TriangleMesh mesh;
    std::vector<int> meshTriangle; // of each entry of triangles
    Triangles triangles;
    Tree tree;
    double reach = 0.0; // a length that leaves the mesh from anywhere inside its box
};

NearestOnMesh::NearestOnMesh(const TriangleMesh &mesh) : mImplementation(std::make_unique<Implementation>())
{
    Implementation &m = *mImplementation;
    m.mesh = mesh;
    m.reach = 2.0 * boundingBox(mesh.vertices).diagonal();
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Triangle &corners = mesh.triangles[t];
        const Kernel::Triangle_3 triangle(toPoint(mesh.vertices[corners[0]]),
                                          toPoint(mesh.vertices[corners[1]]),
                                          toPoint(mesh.vertices[corners[2]]));
        if (!(mesh.areaVector(t).squaredNorm() > 0.0) || triangle.is_degenerate())
            continue;
        m.meshTriangle.push_back(t);
        m.triangles.push_back(triangle);
    }
    DUCTUS_ASSERT(!m.triangles.empty());
    m.tree.rebuild(m.triangles.cbegin(), m.triangles.cend());
    // Built here, not at the first query: then queries only read and need no lock.
    m.tree.build();
    const bool hinted = m.tree.accelerate_distance_queries();
    DUCTUS_ASSERT(hinted);
}

NearestOnMesh::~NearestOnMesh() = default;
NearestOnMesh::NearestOnMesh(NearestOnMesh &&) noexcept = default;

NearestPoint NearestOnMesh::nearest(const Vec3 &query) const
{
    const Implementation &m = *mImplementation;
    const auto hit = m.tree.closest_point_and_primitive(toPoint(query));
    NearestPoint result;
    result.triangle = m.meshTriangle[hit.second - m.triangles.cbegin()];
    const Triangle &corners = m.mesh.triangles[result.triangle];
    const Vec3 &a = m.mesh.vertices[corners[0]];
    const Vec3 &b = m.mesh.vertices[corners[1]];
    const Vec3 &c = m.mesh.vertices[corners[2]];
    result.barycentric = nearestBarycentric(query, a, b, c);
    result.point = result.barycentric[0] * a + result.barycentric[1] * b + result.barycentric[2] * c;
    result.distance = (query - result.point).norm();
    return result;
}

bool NearestOnMesh::isInside(const Vec3 &query) const
{
    const Implementation &m = *mImplementation;
    const CGAL::Bbox_3 box = m.tree.bbox();
    for (int k = 0; k < 3; ++k)
        if (!(query[k] >= box.min(k) && query[k] <= box.max(k)))
            return false;
    const Point p = toPoint(query);
    int winding = 0;
    for (const Vec3 &direction : rayDirections) {
        const Point q = toPoint(query + m.reach * direction);
        std::vector<Tree::Primitive_id> met;
        m.tree.all_intersected_primitives(Kernel::Segment_3(p, q), std::back_inserter(met));
        winding = 0;
        bool clear = true;
        for (const Tree::Primitive_id &id : met) {
            const Crossing c = crossing(p, q, *id);
            clear = clear && c != Crossing::Unclear;
            winding += c == Crossing::Outwards ? 1 : c == Crossing::Inwards ? -1 : 0;
        }
        if (clear)
            return winding > 0;
    }
    return winding > 0; // every ray meets an edge: the query lies on one
}

} // namespace ductus
