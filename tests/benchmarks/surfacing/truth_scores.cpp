#include "benchmarks/surfacing/truth_scores.h"

#include "support/evaluation.h"

namespace ductus {

namespace {

DistanceScore scoreOf(const DeviationStatistics &statistics)
{
    return {statistics.median, statistics.p95, statistics.max};
}

} // namespace

Result<TruthScores> scoreAgainstTruth(const TriangleMesh &result, const std::vector<int> &triangleRegions,
                                      const SyntheticSketch &sketch, int samples)
{
    EvaluationOptions options;
    options.samples = samples;
    const Result<SurfaceDeviation> surface = surfaceDeviation(result, sketch.truth.mesh, options);
    if (!surface)
        return surface.error();
    const Result<DeviationStatistics> strokes = strokeDeviation(sketch.strokes, result);
    if (!strokes)
        return strokes.error();
    const Result<CreaseScore> creases = creaseScore(result, sketch.truth, options);
    if (!creases)
        return creases.error();

    TruthScores scores;
    scores.resultToTruth = scoreOf(surface->resultToTruth);
    scores.truthToResult = scoreOf(surface->truthToResult);
    scores.strokesToResult = scoreOf(*strokes);
    scores.creaseRecall = creases->recall;
    scores.creasePrecision = creases->precision;
    scores.regions = regionCount(result, triangleRegions);
    return scores;
}

} // namespace ductus
