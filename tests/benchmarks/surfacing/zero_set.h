// The variational fit through given points as a mesh, with its cost and its distance to a known surface.
#pragma once

#include "base/result.h"
#include "benchmarks/report/resource_meter.h"
#include "geometry/triangle_mesh.h"

namespace ductus {

/// \a count points far apart from one another on \a mesh; always the same.
std::vector<Vec3> spreadPoints(const TriangleMesh &mesh, int count);

struct ZeroSet
{
    TriangleMesh mesh; // in the coordinates of the points
    ResourceUse fit, contour;
    std::optional<double> peakMegabytes; // the higher of both
};

struct ZeroSetOptions
{
    double lambda = 0.0; // 0 interpolates, as the published runs did
    bool withWrapPrior =
        false; // start also from rough normals of the wrap of the points, as the pipeline does
};

/// The fit to  points, contoured in their box enlarged by a tenth of the diagonal on a grid of 100 cells
/// along its longest side, as the published runs were. The cost of the wrap is not counted. Fails as
/// wrapStrokes, fitVariational and contourFromSeeds do.
Result<ZeroSet> fittedZeroSet(const std::vector<Vec3> &points, const ZeroSetOptions &options);

/// In % of the diagonal of the points' box.
struct DistanceSpread
{
    double median = 0.0, mean = 0.0, p95 = 0.0, max = 0.0;
};

struct ZeroSetDistances
{
    DistanceSpread inputToSet;
    DistanceSpread truthToSet;
    DistanceSpread setToTruth;
};

/// Errors as in tests/support/evaluation.h.
Result<ZeroSetDistances> zeroSetDistances(const ZeroSet &zeroSet, const std::vector<Vec3> &points,
                                          const TriangleMesh &truth);

} // namespace ductus
