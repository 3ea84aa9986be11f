#include "surfacing/proxy/proxy.h"

#include "base/parallel.h"
#include "geometry/mesh_topology.h"
#include "geometry/remesh.h"
#include "strokes/resample.h"
#include "surfacing/proxy/field_surface.h"
#include "surfacing/proxy/flat_ends.h"
#include "surfacing/proxy/least_squares_mesh.h"
#include "surfacing/proxy/local/local_fit.h"
#include "surfacing/proxy/point_subset.h"
#include "surfacing/proxy/proxy_quality.h"
#include "surfacing/proxy/variational_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ductus {

namespace {

// Even samples of every stroke that carries surface.
std::vector<Vec3> samplesOf(const StrokeSet &strokes, double step)
{
    std::vector<Vec3> points;
    for (const Stroke &stroke : strokes.strokes) {
        if (stroke.role != StrokeRole::Surface && stroke.role != StrokeRole::Boundary)
            continue;
        const std::vector<Vec3> even = resampled(stroke.points, step);
        points.insert(points.end(), even.begin(), even.end());
    }
    return points;
}

double evenEdgeLength(const TriangleMesh &mesh, int targetVertices)
{
    // An even mesh of V vertices has about 2 V triangles of area sqrt(3)/4 l^2.
    return std::sqrt(surfaceArea(mesh) / (std::max(targetVertices, 100) * 0.5 * std::sqrt(3.0)));
}

// Repaired, even, on the strokes, even again: what every rung ends with.
Result<TriangleMesh> finished(const TriangleMesh &rough, const std::vector<Vec3> &strokePoints,
                              const ProxyOptions &options, const JobControl &control)
{
    Result<TriangleMesh> mesh = repaired(rough);
    if (!mesh)
        return mesh;
    mesh = remeshed(*mesh, {evenEdgeLength(*mesh, options.targetVertices), 3, 0.0}, control.part(0.0, 0.5));
    if (!mesh)
        return mesh;
    mesh = attracted(*mesh, strokePoints, {}, control.part(0.5, 0.8));
    if (!mesh)
        return mesh;
    return remeshed(*mesh, {evenEdgeLength(*mesh, options.targetVertices), 1, 0.0}, control.part(0.8, 1.0));
}

// Points carried onto a surface they lie near, along its normals.
std::vector<Vec3> ontoSurface(const std::vector<Vec3> &points, const LocalField &field)
{
    std::vector<Vec3> result(points.size());
    parallelFor(0, points.size(), [&](std::size_t i) {
        result[i] = points[i] - field.value(points[i]) * field.normal(points[i]);
    }, 64);
    return result;
}

// A contour, and where the finished proxy is drawn to.
struct Rung
{
    TriangleMesh mesh;
    std::vector<Vec3> targets;
};

Result<Rung> denseRung(const std::vector<Vec3> &points, const Wrap &wrap, bool isOpen, double lambda,
                       const ProxyOptions &options, const JobControl &control)
{
    const Result<HermiteField> field = wholeShapeField(points, wrap, isOpen, lambda, options, control.part(0.0, 0.5));
    if (!field)
        return field.error();
    Result<TriangleMesh> mesh =
        surfaceOfField([&](const Vec3 &x) { return field->value(x); }, points, wrap, isOpen,
                       1.0 / options.cellsAlongDiagonal, options, control.part(0.5, 1.0));
    if (!mesh)
        return mesh.error();
    return Rung{std::move(*mesh), points};
}

Result<Rung> localRung(const std::vector<Vec3> &points, const Wrap &wrap, bool isOpen, double lambda,
                       const ProxyOptions &options, const JobControl &control)
{
    const Result<HermiteField> rough = wholeShapeField(points, wrap, isOpen, lambda, options, control.part(0.0, 0.2));
    if (!rough)
        return rough.error();
    double spacing = options.leastLocalSpacing;
    std::vector<Vec3> spread = spreadOut(points, spacing);
    while (int(spread.size()) > options.mostLocalPoints)
        spread = spreadOut(spread, spacing *= 1.25);
    const Result<LocalFit> fit = fitLocally(spread, *rough, options.local, control.part(0.2, 0.7));
    if (!fit)
        return fit.error();
    // As fine as the points are close, within reason.
    const double cell = std::clamp(1.3 * medianSpacing(spread), 1.0 / 250, 1.0 / options.cellsAlongDiagonal);
    Result<TriangleMesh> mesh = surfaceOfField([&](const Vec3 &x) { return fit->field.value(x); }, spread, wrap,
                                               isOpen, cell, options, control.part(0.7, 1.0));
    if (!mesh)
        return mesh.error();
    return Rung{std::move(*mesh), ontoSurface(spread, fit->field)};
}

} // namespace

std::string_view proxyKindName(ProxyKind kind)
{
    switch (kind) {
    case ProxyKind::Variational: return "variational";
    case ProxyKind::Local: return "local";
    case ProxyKind::Wrap: return "wrap";
    case ProxyKind::Given: return "given";
    }
    return "unknown";
}

Result<Proxy> makeProxy(const StrokeSet &strokes, const ProxyOptions &options, const JobControl &control)
{
    const std::vector<Vec3> drawn = samplesOf(strokes, 0.008);
    if (drawn.size() < 8)
        return Error{ErrorCode::TooLittleData, "Making a proxy", "the sketch has too few strokes for a surface",
                     "Draw more strokes, or give a proxy mesh", ""};
    if (isFlat(drawn))
        return Error{ErrorCode::NoSolution, "Making a proxy", "all strokes lie in one plane",
                     "Draw strokes in depth, or give a proxy mesh", ""};
    Result<Wrap> wrap = wrapStrokes(drawn, options.wrap, control.part(0.0, 0.2));
    if (!wrap)
        return wrap.error();

    Proxy proxy;
    proxy.alpha = wrap->alpha;
    bool isOpen = wrap->isShell;
    for (const Stroke &stroke : strokes.strokes)
        isOpen = isOpen || stroke.role == StrokeRole::Boundary;
    const auto remark = [&](const std::string &text) {
        proxy.remarks += (proxy.remarks.empty() ? "" : "; ") + text;
    };
    const Result<double> lambda =
        chooseLambda(drawn, options.fitPoints, isOpen, options.lambdaChoice, control.part(0.2, 0.3));
    if (!lambda && lambda.error().isCancelled())
        return lambda.error();
    if (!lambda)
        remark(lambda.error().problem);
    std::vector<Vec3> points = drawn;
    if (!isOpen)
        proxy.flatEnds = flatEndsOf(strokes, *wrap, options.flatEnds);
    for (const FlatEnd &end : proxy.flatEnds)
        points.insert(points.end(), end.inside.begin(), end.inside.end());
    struct Attempt
    {
        ProxyKind kind;
        double smoothing;
    };
    std::vector<Attempt> attempts{{ProxyKind::Variational, 1.0}, {ProxyKind::Variational, options.retrySmoothing}};
    if (int(spreadOut(drawn, options.denseSpacing).size()) > options.mostDensePoints)
        attempts.insert(attempts.begin(), {ProxyKind::Local, 1.0});
    if (!options.allowVariational || !lambda)
        attempts.clear();
    for (const Attempt &attempt : attempts) {
        const auto makeRung = attempt.kind == ProxyKind::Local ? localRung : denseRung;
        Result<Rung> rung =
            makeRung(points, *wrap, isOpen, attempt.smoothing * *lambda, options, control.part(0.3, 0.7));
        if (rung)
            rung->mesh = withoutStrayComponents(rung->mesh, points);
        if (rung)
            if (const std::optional<std::string> fault = proxyFault(rung->mesh, wrap->mesh, points, options.quality)) {
                remark(*fault);
                continue;
            }
        Result<TriangleMesh> mesh =
            rung ? finished(rung->mesh, rung->targets, options, control.part(0.7, 1.0)) : rung.error();
        if (!mesh) {
            if (mesh.error().isCancelled())
                return mesh.error();
            remark(mesh.error().problem);
            continue;
        }
        proxy.mesh = std::move(*mesh);
        proxy.kind = attempt.kind;
        proxy.isOpen = isOpen;
        proxy.lambda = attempt.smoothing * *lambda;
        return proxy;
    }
    Result<TriangleMesh> mesh = finished(wrap->mesh, points, options, control.part(0.7, 1.0));
    if (!mesh)
        return mesh.error();
    proxy.mesh = std::move(*mesh);
    proxy.kind = ProxyKind::Wrap;
    return proxy;
}

Result<Proxy> proxyFromMesh(const TriangleMesh &mesh, const StrokeSet &strokes, const ProxyOptions &options,
                            const JobControl &control)
{
    Result<TriangleMesh> clean = finished(mesh, samplesOf(strokes, 0.008), options, control);
    if (!clean)
        return clean.error();
    Proxy proxy;
    proxy.mesh = std::move(*clean);
    proxy.kind = ProxyKind::Given;
    proxy.isOpen = manifoldReport(proxy.mesh).borderEdges > 0;
    return proxy;
}

} // namespace ductus
