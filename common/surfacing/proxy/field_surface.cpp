#include "surfacing/proxy/field_surface.h"

#include "geometry/hole_filling.h"
#include "geometry/nearest.h"
#include "geometry/remesh.h"
#include "surfacing/proxy/point_subset.h"
#include "surfacing/proxy/proxy_quality.h"
#include "surfacing/proxy/variational_fit.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

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
std::vector<Vec3> fillersOf(const Wrap &wrap, const std::vector<Vec3> &strokePoints,
                            const ProxyOptions &options)
{
    std::vector<Vec3> candidates;
    for (int t = 0; t < wrap.mesh.triangleCount(); ++t) {
        const Triangle &corners = wrap.mesh.triangles[std::size_t(t)];
        const Vec3 &a = wrap.mesh.vertices[std::size_t(corners[0])],
                   &b = wrap.mesh.vertices[std::size_t(corners[1])],
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

} // namespace

Result<HermiteField> wholeShapeField(const std::vector<Vec3> &strokePoints, const Wrap &wrap, bool isOpen,
                                     double lambda, const ProxyOptions &options, const JobControl &control)
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

Result<FieldSurface> surfaceOfField(const ScalarField &field, const std::vector<Vec3> &seeds,
                                    const Wrap &wrap, bool isOpen, double cell, const ProxyOptions &options,
                                    const JobControl &control)
{
    const NearestOnMesh nearestWrap(wrap.mesh);
    const Neighbourhood neighbourhood{nearestWrap, options.domainBand};
    Box3 box = boundingBox(wrap.mesh.vertices);
    box.min.array() -= options.domainBand + 2 * cell;
    box.max.array() += options.domainBand + 2 * cell;

    // Everything outside the neighbourhood counts as outside the shape, so the contour is closed: by a cap
    // there.
    const ScalarField capped = [&](const Vec3 &x) { return std::max(field(x), neighbourhood(x)); };
    Result<TriangleMesh> contour = contourFromSeeds(capped, seeds, box, {cell, 3'000'000, 2}, control);
    if (!contour)
        return contour.error();
    TriangleMesh open = *contour;
    open.triangles.clear();
    for (int t = 0; t < contour->triangleCount(); ++t) {
        const Vec3 centre = contour->centroid(t);
        const bool isCap = neighbourhood(centre) > -0.25 * cell && field(centre) < 0.0;
        if (!isCap)
            open.triangles.push_back(contour->triangles[std::size_t(t)]);
    }
    const double cappedShare = 1.0 - surfaceArea(open) / surfaceArea(*contour);
    if (!isOpen)
        return FieldSurface{std::move(*contour), cappedShare};

    Result<TriangleMesh> sheet = repaired(withoutStrayComponents(compacted(open), seeds));
    if (!sheet)
        return sheet.error();
    const std::vector<std::vector<int>> loops = borderLoops(*sheet);
    if (!loops.empty())
        sheet = withHolesFilled(*sheet, options.holeShare * loopLength(*sheet, loops.front()));
    if (!sheet)
        return sheet.error();
    return FieldSurface{std::move(*sheet), cappedShare};
}

} // namespace ductus
