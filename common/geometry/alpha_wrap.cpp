#include "geometry/alpha_wrap.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <cmath>
#include <exception>
#include <new>

namespace ductus {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr const char *attempted = "Wrapping the strokes";

// Finer wraps would need more than about 10^8 triangles; CGAL would eat all memory before failing.
constexpr double maxDiagonalOverAlpha = 1e4;

TriangleMesh fromSurfaceMesh(const SurfaceMesh &wrap)
{
    TriangleMesh mesh;
    mesh.vertices.reserve(wrap.number_of_vertices());
    std::vector<int> number(wrap.num_vertices(), -1);
    for (const auto v : wrap.vertices()) {
        number[v] = mesh.vertexCount();
        const Kernel::Point_3 &p = wrap.point(v);
        mesh.vertices.push_back({p.x(), p.y(), p.z()});
    }
    mesh.triangles.reserve(wrap.number_of_faces());
    for (const auto f : wrap.faces()) {
        Triangle t{};
        int k = 0;
        for (const auto v : wrap.vertices_around_face(wrap.halfedge(f)))
            t[k++] = number[v];
        mesh.triangles.push_back(t);
    }
    return mesh;
}

} // namespace

Result<TriangleMesh> alphaWrap(const std::vector<Vec3> &points, const AlphaWrapOptions &options)
{
    const auto positive = [](double x) { return std::isfinite(x) && x > 0.0; };
    if (!positive(options.alpha) || !positive(options.offset))
        return Error{ErrorCode::InvalidArgument, attempted, "alpha and offset must be positive numbers", "",
                     ""};
    if (points.empty())
        return Error{ErrorCode::TooLittleData, attempted, "there are no points", "", ""};
    std::vector<Kernel::Point_3> input;
    input.reserve(points.size());
    for (const Vec3 &p : points) {
        if (!p.allFinite())
            return Error{ErrorCode::Malformed, attempted, "a coordinate is not a finite number", "", ""};
        input.emplace_back(p.x(), p.y(), p.z());
    }
    const double diagonal = boundingBox(points).diagonal();
    if (diagonal > maxDiagonalOverAlpha * std::min(options.alpha, options.offset * 100.0))
        return Error{ErrorCode::InvalidArgument, attempted,
                     "alpha or offset is too small for points this far apart", "Choose a coarser wrap", ""};
    try {
        SurfaceMesh wrap;
        CGAL::alpha_wrap_3(input, options.alpha, options.offset, wrap);
        if (wrap.number_of_faces() == 0)
            return Error{ErrorCode::NoSolution, attempted, "the wrap is empty", "Choose a larger alpha", ""};
        return fromSurfaceMesh(wrap);
    } catch (const std::bad_alloc &) {
        return Error{ErrorCode::TooLarge, attempted, "there is not enough memory", "Choose a coarser wrap",
                     ""};
    } catch (const std::exception &e) { // CGAL reports broken preconditions this way
        return Error{ErrorCode::NoSolution, attempted, e.what(), "Choose another alpha or offset", ""};
    }
}

} // namespace ductus
