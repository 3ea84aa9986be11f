// All that tests/support can say about a result whose truth is known, in one structure.
#pragma once

#include "base/result.h"
#include "support/sketch_synthesis.h"

namespace ductus {

/// In % of the diagonal of the truth's box.
struct DistanceScore
{
    double median = 0.0;
    double p95 = 0.0;
    double max = 0.0;
};

struct TruthScores
{
    DistanceScore resultToTruth;
    DistanceScore truthToResult;
    DistanceScore strokesToResult;
    double creaseRecall = 0.0; // shares, evaluation.h
    double creasePrecision = 0.0;
    int regions = 0; // connected areas of one label

    /// The worse of the two directions, which the target is about.
    double median() const { return std::max(resultToTruth.median, truthToResult.median); }
};

/// \a samples a mesh; errors as in evaluation.h.
Result<TruthScores> scoreAgainstTruth(const TriangleMesh &result, const std::vector<int> &triangleRegions,
                                      const SyntheticSketch &sketch, int samples);

} // namespace ductus
