#include "surfacing/proxy/proxy.h"

#include "geometry/mesh_topology.h"
#include "geometry/remesh.h"
#include "strokes/resample.h"
#include "surfacing/proxy/least_squares_mesh.h"
#include "surfacing/proxy/point_subset.h"
#include "surfacing/proxy/rung_candidates.h"
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

} // namespace

std::string_view proxyKindName(ProxyKind kind)
{
    switch (kind) {
    case ProxyKind::Variational:
        return "variational";
    case ProxyKind::Local:
        return "local";
    case ProxyKind::Wrap:
        return "wrap";
    case ProxyKind::Given:
        return "given";
    }
    return "unknown";
}

Result<Proxy> makeProxy(const StrokeSet &strokes, const ProxyOptions &options, const JobControl &control)
{
    const std::vector<Vec3> drawn = samplesOf(strokes, 0.008);
    if (drawn.size() < 8)
        return Error{ErrorCode::TooLittleData, "Making a proxy",
                     "the sketch has too few strokes for a surface",
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
    const ProxyGround ground = groundOn(std::move(*wrap), strokes, drawn, isOpen, options);
    proxy.flatEnds = ground.flatEnds;
    struct Attempt
    {
        ProxyKind kind;
        double smoothing;
    };
    std::vector<Attempt> attempts{{ProxyKind::Variational, 1.0},
                                  {ProxyKind::Variational, options.retrySmoothing}};
    if (int(spreadOut(drawn, options.denseSpacing).size()) > options.mostDensePoints)
        attempts.insert(attempts.begin(), {ProxyKind::Local, 1.0});
    if (!options.allowVariational || !lambda)
        attempts.clear();
    for (const Attempt &attempt : attempts) {
        const RungCandidate best = calmest(attempt.kind, ground, strokes, drawn, attempt.smoothing * *lambda,
                                           options, control.part(0.3, 0.7));
        Result<TriangleMesh> mesh =
            best.rung ? finished(best.rung->mesh, best.rung->targets, options, control.part(0.7, 1.0))
                      : best.rung.error();
        if (!mesh) {
            if (mesh.error().isCancelled())
                return mesh.error();
            remark(mesh.error().problem);
            continue;
        }
        proxy.mesh = std::move(*mesh);
        proxy.kind = attempt.kind;
        proxy.isOpen = isOpen;
        proxy.alpha = best.ground.wrap.alpha;
        proxy.flatEnds = best.ground.flatEnds;
        proxy.lambda = best.lambda;
        return proxy;
    }
    Result<TriangleMesh> mesh = finished(ground.wrap.mesh, ground.points, options, control.part(0.7, 1.0));
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
