#include "surfacing/proxy/proxy.h"

#include "geometry/hole_filling.h"
#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"
#include "geometry/remesh.h"
#include "strokes/resample.h"
#include "surfacing/proxy/contour.h"
#include "surfacing/proxy/least_squares_mesh.h"
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

struct Neighbourhood
{
    const NearestOnMesh &wrap;
    double band;

    // Negative inside the region the smooth surface may use.
    double operator()(const Vec3 &x) const
    {
        const double distance = wrap.nearest(x).distance;
        return (wrap.isInside(x) ? -distance : distance) - band;
    }
};

// Points of the wrap far from all strokes, moved in by the offset the wrap keeps.
std::vector<Vec3> fillersOf(const Wrap &wrap, const std::vector<Vec3> &strokePoints, const ProxyOptions &options)
{
    std::vector<Vec3> candidates;
    for (int t = 0; t < wrap.mesh.triangleCount(); ++t) {
        const Triangle &corners = wrap.mesh.triangles[std::size_t(t)];
        const Vec3 &a = wrap.mesh.vertices[std::size_t(corners[0])], &b = wrap.mesh.vertices[std::size_t(corners[1])],
                   &c = wrap.mesh.vertices[std::size_t(corners[2])];
        const double size = std::max({(a - b).norm(), (b - c).norm(), (c - a).norm()});
        const int n = std::max(1, int(std::ceil(3.0 * size / options.fillerDistance)));
        const Vec3 inwards = options.wrap.offset * wrap.mesh.faceNormal(t);
        for (int i = 0; i < n; ++i)
            for (int j = 0; i + j < n; ++j) {
                const double u = (i + 1.0 / 3) / n, v = (j + 1.0 / 3) / n;
                candidates.push_back(a + u * (b - a) + v * (c - a) - inwards);
            }
    }
    std::vector<Vec3> far;
    for (const Vec3 &p : candidates) {
        double nearest = 1.0;
        for (const Vec3 &q : strokePoints)
            nearest = std::min(nearest, (p - q).squaredNorm());
        if (nearest > options.fillerDistance * options.fillerDistance)
            far.push_back(p);
    }
    std::vector<Vec3> fillers;
    for (int i : farthestPoints(far, options.fitPoints / 2, options.fillerDistance))
        fillers.push_back(far[std::size_t(i)]);
    return fillers;
}

Result<HermiteField> fitField(const std::vector<Vec3> &strokePoints, const Wrap &wrap, bool isOpen, double lambda,
                              const ProxyOptions &options, const JobControl &control)
{
    std::vector<Vec3> points = isOpen ? std::vector<Vec3>() : fillersOf(wrap, strokePoints, options);
    VariationalFitOptions fitOptions;
    fitOptions.pointLambdas.assign(points.size(),
                                   std::max(options.leastFillerLambda, options.fillerLambda * lambda));
    for (int i : farthestPoints(strokePoints, options.fitPoints - int(points.size()), 1e-3))
        points.push_back(strokePoints[std::size_t(i)]);
    fitOptions.pointLambdas.resize(points.size(), lambda);
    std::vector<Vec3> prior;
    const NearestOnMesh nearestWrap(wrap.mesh);
    for (const Vec3 &p : points)
        prior.push_back(wrap.mesh.faceNormal(nearestWrap.nearest(p).triangle));
    const Result<VariationalFit> fit = fitVariational(points, prior, fitOptions, control);
    if (!fit)
        return fit.error();
    return fit->field;
}

Result<TriangleMesh> variationalRung(const std::vector<Vec3> &points, const Wrap &wrap, bool isOpen, double lambda,
                                     const ProxyOptions &options, const JobControl &control)
{
    const Result<HermiteField> field = fitField(points, wrap, isOpen, lambda, options, control.part(0.0, 0.5));
    if (!field)
        return field.error();
    const NearestOnMesh nearestWrap(wrap.mesh);
    const Neighbourhood neighbourhood{nearestWrap, options.domainBand};
    Box3 box = boundingBox(wrap.mesh.vertices);
    const double cell = 1.0 / options.cellsAlongDiagonal;
    box.min.array() -= options.domainBand + 2 * cell;
    box.max.array() += options.domainBand + 2 * cell;

    // Everything outside the neighbourhood counts as outside the shape, so the contour is closed: by a cap there.
    const ScalarField capped = [&](const Vec3 &x) { return std::max(field->value(x), neighbourhood(x)); };
    Result<TriangleMesh> contour =
        contourFromSeeds(capped, points, box, {cell, 3'000'000, 2}, control.part(0.5, 1.0));
    if (!contour || !isOpen)
        return contour;

    TriangleMesh open = *contour;
    open.triangles.clear();
    for (int t = 0; t < contour->triangleCount(); ++t) {
        const Vec3 centre = contour->centroid(t);
        const bool isCap = neighbourhood(centre) > -0.25 * cell && field->value(centre) < 0.0;
        if (!isCap)
            open.triangles.push_back(contour->triangles[std::size_t(t)]);
    }
    Result<TriangleMesh> sheet = repaired(withoutStrayComponents(compacted(open), points));
    if (!sheet)
        return sheet;
    const std::vector<std::vector<int>> loops = borderLoops(*sheet);
    return loops.empty() ? *sheet : withHolesFilled(*sheet, options.holeShare * loopLength(*sheet, loops.front()));
}

} // namespace

std::string_view proxyKindName(ProxyKind kind)
{
    switch (kind) {
    case ProxyKind::Variational: return "variational";
    case ProxyKind::Wrap: return "wrap";
    case ProxyKind::Given: return "given";
    }
    return "unknown";
}

Result<Proxy> makeProxy(const StrokeSet &strokes, const ProxyOptions &options, const JobControl &control)
{
    const std::vector<Vec3> points = samplesOf(strokes, 0.008);
    if (points.size() < 8)
        return Error{ErrorCode::TooLittleData, "Making a proxy", "the sketch has too few strokes for a surface",
                     "Draw more strokes, or give a proxy mesh", ""};
    if (isFlat(points))
        return Error{ErrorCode::NoSolution, "Making a proxy", "all strokes lie in one plane",
                     "Draw strokes in depth, or give a proxy mesh", ""};
    Result<Wrap> wrap = wrapStrokes(points, options.wrap, control.part(0.0, 0.2));
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
        chooseLambda(points, options.fitPoints, isOpen, options.lambdaChoice, control.part(0.2, 0.3));
    if (!lambda && lambda.error().isCancelled())
        return lambda.error();
    if (!lambda)
        remark(lambda.error().problem);
    for (double smoothing : {1.0, options.retrySmoothing}) {
        if (!options.allowVariational || !lambda)
            break;
        Result<TriangleMesh> rung =
            variationalRung(points, *wrap, isOpen, smoothing * *lambda, options, control.part(0.3, 0.7));
        if (rung)
            rung = withoutStrayComponents(*rung, points);
        if (rung)
            if (const std::optional<std::string> fault = proxyFault(*rung, wrap->mesh, points, options.quality)) {
                remark(*fault);
                continue;
            }
        if (rung)
            rung = finished(*rung, points, options, control.part(0.7, 1.0));
        if (!rung) {
            if (rung.error().isCancelled())
                return rung.error();
            remark(rung.error().problem);
            continue;
        }
        proxy.mesh = std::move(*rung);
        proxy.kind = ProxyKind::Variational;
        proxy.isOpen = isOpen;
        proxy.lambda = smoothing * *lambda;
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
