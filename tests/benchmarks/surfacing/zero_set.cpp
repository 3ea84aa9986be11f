#include "benchmarks/surfacing/zero_set.h"

#include "geometry/nearest.h"
#include "support/evaluation.h"
#include "surfacing/proxy/contour.h"
#include "surfacing/proxy/point_subset.h"
#include "surfacing/proxy/variational_fit.h"
#include "surfacing/proxy/wrap_proxy.h"
#include "surfacing/sketch/unit_frame.h"

namespace ductus {

namespace {

constexpr int cellsAlongSide = 100;
constexpr double margin = 0.1; // of the diagonal, around the points

std::vector<Vec3> placesOf(const std::vector<SurfacePoint> &samples)
{
    std::vector<Vec3> places;
    for (const SurfacePoint &sample : samples)
        places.push_back(sample.point);
    return places;
}

DistanceSpread spreadOf(const std::vector<Vec3> &from, const TriangleMesh &to, double diagonal)
{
    const NearestOnMesh nearest(to);
    std::vector<double> distances;
    for (const Vec3 &point : from)
        distances.push_back(nearest.nearest(point).distance);
    const DeviationStatistics statistics = deviationStatistics(distances, diagonal);
    return {statistics.median, statistics.mean, statistics.p95, statistics.max};
}

UnitFrame frameOf(const std::vector<Vec3> &points)
{
    const Box3 box = boundingBox(points);
    return {box.centre(), box.diagonal()};
}

Result<std::vector<Vec3>> wrapNormals(const std::vector<Vec3> &points)
{
    const Result<Wrap> wrap = wrapStrokes(points, {}, JobControl());
    if (!wrap)
        return wrap.error();
    const NearestOnMesh nearest(wrap->mesh);
    std::vector<Vec3> normals;
    for (const Vec3 &point : points)
        normals.push_back(wrap->mesh.faceNormal(nearest.nearest(point).triangle));
    return normals;
}

} // namespace

std::vector<Vec3> spreadPoints(const TriangleMesh &mesh, int count)
{
    const std::vector<Vec3> candidates = placesOf(sampledByArea(mesh, 20 * count, 1));
    std::vector<Vec3> points;
    for (const int i : farthestPoints(candidates, count, 0.0))
        points.push_back(candidates[std::size_t(i)]);
    return points;
}

Result<ZeroSet> fittedZeroSet(const std::vector<Vec3> &points, const ZeroSetOptions &options)
{
    const UnitFrame frame = frameOf(points);
    std::vector<Vec3> unit;
    for (const Vec3 &point : points)
        unit.push_back(frame.unitFromInput(point));

    std::vector<Vec3> prior;
    if (options.withWrapPrior) {
        Result<std::vector<Vec3>> normals = wrapNormals(unit);
        if (!normals)
            return normals.error();
        prior = std::move(*normals);
    }

    ZeroSet zeroSet;
    VariationalFitOptions fitOptions;
    fitOptions.lambda = options.lambda;
    const ResourceMeter fitMeter;
    const Result<VariationalFit> fit = fitVariational(unit, prior, fitOptions, JobControl());
    zeroSet.fit = fitMeter.used();
    if (!fit)
        return fit.error();

    Box3 box = boundingBox(unit);
    const double longestSide = (box.max - box.min).maxCoeff();
    box.min.array() -= margin;
    box.max.array() += margin;
    const ScalarField field = [&](const Vec3 &x) { return fit->field.value(x); };
    const ResourceMeter contourMeter;
    ContourOptions contourOptions;
    contourOptions.cellSize = longestSide / cellsAlongSide;
    Result<TriangleMesh> contour = contourFromSeeds(field, unit, box, contourOptions, JobControl());
    zeroSet.contour = contourMeter.used();
    if (!contour)
        return contour.error();
    zeroSet.mesh = inInputFrame(*contour, frame);
    if (zeroSet.fit.peakMegabytes && zeroSet.contour.peakMegabytes)
        zeroSet.peakMegabytes = std::max(*zeroSet.fit.peakMegabytes, *zeroSet.contour.peakMegabytes);
    return zeroSet;
}

Result<ZeroSetDistances> zeroSetDistances(const ZeroSet &zeroSet, const std::vector<Vec3> &points,
                                          const TriangleMesh &truth)
{
    // surfaceDeviation measures in the diagonal of the truth; here it is the input's, as the published
    // figures have it. It still checks both meshes.
    if (const Result<SurfaceDeviation> sound = surfaceDeviation(zeroSet.mesh, truth, {.samples = 100});
        !sound)
        return sound.error();
    const double diagonal = frameOf(points).diagonal;
    ZeroSetDistances distances;
    distances.inputToSet = spreadOf(points, zeroSet.mesh, diagonal);
    distances.truthToSet = spreadOf(placesOf(sampledByArea(truth, 20000, 1)), zeroSet.mesh, diagonal);
    distances.setToTruth = spreadOf(placesOf(sampledByArea(zeroSet.mesh, 20000, 2)), truth, diagonal);
    return distances;
}

} // namespace ductus
