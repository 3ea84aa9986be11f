#include "surfacing/proxy/rungs.h"

#include "base/parallel.h"
#include "geometry/hole_filling.h"
#include "geometry/mesh_topology.h"
#include "surfacing/proxy/field_surface.h"
#include "surfacing/proxy/local/local_fit.h"
#include "surfacing/proxy/point_subset.h"

#include <algorithm>

namespace ductus {

namespace {

// Points carried onto a surface they lie near, along its normals.
std::vector<Vec3> ontoSurface(const std::vector<Vec3> &points, const LocalField &field)
{
    std::vector<Vec3> result(points.size());
    parallelFor(
        0, points.size(),
        [&](std::size_t i) { result[i] = points[i] - field.value(points[i]) * field.normal(points[i]); }, 64);
    return result;
}

// The genus, of all components together.
int tunnelsThrough(const TriangleMesh &mesh)
{
    const MeshTopology topology(mesh);
    int components = 0;
    triangleComponents(topology, &components);
    const int euler = mesh.vertexCount() - int(topology.edges.size()) + mesh.triangleCount();
    return (2 * components - int(borderLoops(mesh).size()) - euler) / 2;
}

struct Contour
{
    FieldSurface surface;
    std::vector<Vec3> targets;
};

Result<Contour> denseContour(const ProxyGround &ground, double lambda, const ProxyOptions &options,
                             const JobControl &control)
{
    const Result<HermiteField> field =
        wholeShapeField(ground.points, ground.wrap, ground.isOpen, lambda, options, control.part(0.0, 0.5));
    if (!field)
        return field.error();
    Result<FieldSurface> surface =
        surfaceOfField([&](const Vec3 &x) { return field->value(x); }, ground.points, ground.wrap,
                       ground.isOpen, 1.0 / options.cellsAlongDiagonal, options, control.part(0.5, 1.0));
    if (!surface)
        return surface.error();
    return Contour{std::move(*surface), ground.points};
}

Result<Contour> localContour(const ProxyGround &ground, double lambda, const ProxyOptions &options,
                             const JobControl &control)
{
    const Result<HermiteField> rough =
        wholeShapeField(ground.points, ground.wrap, ground.isOpen, lambda, options, control.part(0.0, 0.2));
    if (!rough)
        return rough.error();
    double spacing = options.leastLocalSpacing;
    std::vector<Vec3> spread = spreadOut(ground.points, spacing);
    while (int(spread.size()) > options.mostLocalPoints)
        spread = spreadOut(spread, spacing *= 1.25);
    const Result<LocalFit> fit = fitLocally(spread, *rough, options.local, control.part(0.2, 0.7));
    if (!fit)
        return fit.error();
    // As fine as the points are close, within reason.
    const double cell = std::clamp(1.3 * medianSpacing(spread), 1.0 / 250, 1.0 / options.cellsAlongDiagonal);
    Result<FieldSurface> surface =
        surfaceOfField([&](const Vec3 &x) { return fit->field.value(x); }, spread, ground.wrap, ground.isOpen,
                       cell, options, control.part(0.7, 1.0));
    if (!surface)
        return surface.error();
    return Contour{std::move(*surface), ontoSurface(spread, fit->field)};
}

} // namespace

ProxyGround groundOn(Wrap wrap, const StrokeSet &strokes, const std::vector<Vec3> &drawn, bool isOpen,
                     const ProxyOptions &options)
{
    ProxyGround ground{std::move(wrap), isOpen, {}, drawn};
    if (!isOpen) {
        ground.flatEnds = flatEndsOf(strokes, ground.wrap, options.flatEnds);
        ground.tunnels = tunnelsThrough(ground.wrap.mesh);
    }
    for (const FlatEnd &end : ground.flatEnds)
        ground.points.insert(ground.points.end(), end.inside.begin(), end.inside.end());
    return ground;
}

Result<ProxyRung> makeRung(ProxyKind kind, const ProxyGround &ground, double lambda,
                           const ProxyOptions &options, const JobControl &control)
{
    Result<Contour> contour = kind == ProxyKind::Local ? localContour(ground, lambda, options, control)
                                                       : denseContour(ground, lambda, options, control);
    if (!contour)
        return contour.error();
    ProxyRung rung{withoutStrayComponents(contour->surface.mesh, ground.points), std::move(contour->targets)};
    if (const std::optional<std::string> fault =
            proxyFault(rung.mesh, ground.wrap.mesh, ground.points, options.quality))
        return Error{ErrorCode::NoSolution, "Making a proxy", *fault,
                     "Draw more strokes, or give a proxy mesh", ""};
    rung.tunnels = std::max(0, tunnelsThrough(rung.mesh) - ground.tunnels);
    rung.disorder = options.disorder.tunnel * rung.tunnels;
    if (!ground.isOpen)
        rung.disorder += contour->surface.cappedShare;
    return rung;
}

} // namespace ductus
