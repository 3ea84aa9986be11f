// How far a surfacing result is from the truth, in % of the diagonal of the truth's box (surfacing.md section
// 3).
#pragma once

#include "base/result.h"
#include "strokes/stroke.h"
#include "support/sketch_synthesis.h"

#include <cstdint>

namespace ductus {

/// Of a set of distances, in % of a diagonal.
struct DeviationStatistics
{
    double median = 0.0;
    double mean = 0.0;
    double p95 = 0.0;
    double max = 0.0;
};

/// \a distances in mesh units; zeros for an empty list.
DeviationStatistics deviationStatistics(std::vector<double> distances, double diagonal);

struct SurfacePoint
{
    Vec3 point;
    int triangle = -1;
};

/// \a count points of equal share of the area: one at a random place in each of \a count equal slices of the
/// summed triangle areas. Triangles without area get none; an empty list for a mesh without area.
std::vector<SurfacePoint> sampledByArea(const TriangleMesh &mesh, int count, std::uint64_t seed);

struct EvaluationOptions
{
    int samples = 20000; // per mesh
    std::uint64_t seed = 1;
    double creaseTolerance = 0.01;    // of the diagonal
    double creaseAngleDegrees = 20.0; // an edge of the result with a larger dihedral angle is a crease
};

struct SurfaceDeviation
{
    DeviationStatistics resultToTruth; // superfluous and misplaced surface
    DeviationStatistics truthToResult; // missing surface
};

/// Fails with TooLittleData if one of the meshes has no area, InvalidArgument for corners out of range or not
/// finite.
Result<SurfaceDeviation> surfaceDeviation(const TriangleMesh &result, const TriangleMesh &truth,
                                          const EvaluationOptions &options = {});

/// Distances of evenly resampled stroke points (step 0.2 % of the diagonal of \a mesh) to the mesh; strokes
/// with role Ignored, Inner or Skeletal do not count. Errors as above; TooLittleData without strokes.
Result<DeviationStatistics> strokeDeviation(const StrokeSet &strokes, const TriangleMesh &mesh);

struct CreaseScore
{
    /// Share of the length of truth.drawnCreases (creases above Solid::sharpDegrees that a stroke shows)
    /// within the tolerance of a crease edge of the result.
    double recall = 1.0;
    /// Share of the length of the result's crease edges within the tolerance of a crease edge of the true
    /// mesh.
    double precision = 1.0;
    double resultLength = 0.0; // of all crease edges, in mesh units
};

/// Both shares are 1 where there is nothing to find. Errors as above.
Result<CreaseScore> creaseScore(const TriangleMesh &result, const GroundTruth &truth,
                                const EvaluationOptions &options = {});

/// Connected regions of equal label (across shared edges); labels one a triangle.
int regionCount(const TriangleMesh &mesh, const std::vector<int> &triangleLabels);

/// regionCount over the number of true faces; 1 is right. Fails with InvalidArgument if labels and triangles
/// differ in number.
Result<double> regionCountRatio(const TriangleMesh &result, const std::vector<int> &triangleLabels,
                                const GroundTruth &truth);

} // namespace ductus
