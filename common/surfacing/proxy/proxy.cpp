#include "surfacing/proxy/proxy.h"

#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"
#include "geometry/remesh.h"
#include "strokes/resample.h"
#include "surfacing/proxy/contour.h"
#include "surfacing/proxy/least_squares_mesh.h"
#include "surfacing/proxy/point_subset.h"
#include "surfacing/proxy/proxy_quality.h"
#include "surfacing/proxy/variational_fit.h"

#include <cmath>

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

struct VariationalRung
{
    TriangleMesh mesh;
    bool isOpen = false;
};

Result<VariationalRung> variationalRung(const std::vector<Vec3> &points, const Wrap &wrap, double lambda,
                                        const ProxyOptions &options, const JobControl &control)
{
    const std::vector<int> chosen = farthestPoints(points, options.fitPoints, 1e-3);
    std::vector<Vec3> fitPoints, prior;
    const NearestOnMesh nearestWrap(wrap.mesh);
    for (int i : chosen) {
        fitPoints.push_back(points[std::size_t(i)]);
        prior.push_back(wrap.mesh.faceNormal(nearestWrap.nearest(fitPoints.back()).triangle));
    }
    VariationalFitOptions fitOptions;
    fitOptions.lambda = lambda;
    const Result<VariationalFit> fit = fitVariational(fitPoints, prior, fitOptions, control.part(0.0, 0.5));
    if (!fit)
        return fit.error();

    const Neighbourhood neighbourhood{nearestWrap, options.domainBand};
    Box3 box = boundingBox(wrap.mesh.vertices);
    const double cell = 1.0 / options.cellsAlongDiagonal;
    box.min.array() -= options.domainBand + 2 * cell;
    box.max.array() += options.domainBand + 2 * cell;

    // Capped: everything outside the neighbourhood is outside the shape, so the contour is closed.
    const ScalarField capped = [&](const Vec3 &x) { return std::max(fit->field.value(x), neighbourhood(x)); };
    Result<TriangleMesh> contour =
        contourFromSeeds(capped, fitPoints, box, {cell, 3'000'000, 2}, control.part(0.5, 1.0));
    if (!contour)
        return contour.error();
    TriangleMesh mesh = withoutStrayComponents(*contour, points);

    // Triangles on the cap are those where the neighbourhood, not the field, is zero.
    std::vector<char> isCap(mesh.triangles.size(), 0);
    double capArea = 0.0, area = 0.0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Vec3 centre = mesh.centroid(t);
        isCap[std::size_t(t)] = neighbourhood(centre) > -0.25 * cell && fit->field.value(centre) < 0.0;
        const double triangleArea = 0.5 * mesh.areaVector(t).norm();
        area += triangleArea;
        capArea += isCap[std::size_t(t)] ? triangleArea : 0.0;
    }
    VariationalRung rung;
    rung.isOpen = capArea > options.openShare * area;
    if (rung.isOpen) {
        TriangleMesh open = mesh;
        open.triangles.clear();
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            if (!isCap[t])
                open.triangles.push_back(mesh.triangles[t]);
        mesh = withoutStrayComponents(compacted(open), points);
    }
    rung.mesh = std::move(mesh);
    return rung;
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
    Result<Wrap> wrap = wrapStrokes(points, options.wrap, control.part(0.0, 0.2));
    if (!wrap)
        return wrap.error();

    Proxy proxy;
    proxy.alpha = wrap->alpha;
    if (options.allowVariational)
        for (double lambda : options.lambdas) {
            Result<VariationalRung> rung = variationalRung(points, *wrap, lambda, options, control.part(0.2, 0.7));
            if (!rung && rung.error().isCancelled())
                return rung.error();
            std::optional<std::string> fault;
            if (rung)
                fault = proxyFault(rung->mesh, wrap->mesh, points, {});
            else
                fault = rung.error().problem;
            if (fault) {
                proxy.remarks += (proxy.remarks.empty() ? "" : "; ") + *fault;
                continue;
            }
            Result<TriangleMesh> mesh = finished(rung->mesh, points, options, control.part(0.7, 1.0));
            if (!mesh) {
                if (mesh.error().isCancelled())
                    return mesh.error();
                proxy.remarks += (proxy.remarks.empty() ? "" : "; ") + mesh.error().problem;
                continue;
            }
            proxy.mesh = std::move(*mesh);
            proxy.kind = ProxyKind::Variational;
            proxy.isOpen = rung->isOpen;
            proxy.lambda = lambda;
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
