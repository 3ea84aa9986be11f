// Section "truth": every solid drawn with the default hand, surfaced, and compared with itself (surfacing.md
// section 3: median deviation <= 0.3 % of the diagonal, creases where strokes mark them, regions within 20
// %).
#include "benchmarks/report/table.h"
#include "benchmarks/surfacing/benchmark_context.h"
#include "benchmarks/surfacing/truth_scores.h"
#include "surfacing/pipeline/surface_pipeline.h"

#include <cmath>

namespace ductus {

namespace {

constexpr double targetMedian = 0.3; // % of the diagonal

const std::vector<Column> columns{
    {"solid", "solid", 14},
    {"strokes", "strokes", 7},
    {"proxy", "proxy", 11},
    {"resultToTruthMedian", "r>t med", 7, 3},
    {"resultToTruthP95", "p95", 6, 3},
    {"resultToTruthMax", "max", 6, 2},
    {"truthToResultMedian", "t>r med", 7, 3},
    {"truthToResultP95", "p95", 6, 3},
    {"truthToResultMax", "max", 6, 2},
    {"strokeMedian", "stroke med", 10, 3},
    {"strokeMax", "max", 6, 2},
    {"creaseRecall", "recall", 6, 2},
    {"creasePrecision", "precis.", 7, 2},
    {"regions", "regions", 7},
    {"trueFaces", "true", 4},
    {"proxySeconds", "proxy s", 7, 2},
    {"associationSeconds", "assoc s", 7, 2},
    {"segmentationSeconds", "segm s", 7, 2},
    {"extractionSeconds", "extr s", 7, 2},
    {"verdict", "<=0.3%", 6},
};

struct Tally
{
    int solids = 0, hits = 0;
    double worst = 0.0, sum = 0.0;
};

void measure(const Solid &solid, const SurfaceOptions &options, int samples, Table &table, Tally &tally)
{
    ++tally.solids;
    const SyntheticSketch sketch = synthesizeSketch(solid, {});
    const Result<SurfaceResult> result = surfaceSketch(sketch.strokes, std::nullopt, options, JobControl());
    if (!result)
        return table.addFailure(solid.id, result.error().message());
    const Result<TruthScores> scores =
        scoreAgainstTruth(result->mesh, result->triangleRegions, sketch, samples);
    if (!scores)
        return table.addFailure(solid.id, scores.error().message());

    const bool hit = scores->median() <= targetMedian;
    tally.hits += hit;
    tally.worst = std::max(tally.worst, scores->median());
    tally.sum += scores->median();
    const SurfaceTimings &seconds = result->timings;
    table.add({solid.id,
               double(sketch.strokes.strokes.size()),
               std::string(proxyKindName(result->proxy.kind)),
               scores->resultToTruth.median,
               scores->resultToTruth.p95,
               scores->resultToTruth.max,
               scores->truthToResult.median,
               scores->truthToResult.p95,
               scores->truthToResult.max,
               scores->strokesToResult.median,
               scores->strokesToResult.max,
               scores->creaseRecall,
               scores->creasePrecision,
               double(scores->regions),
               double(solid.faceCount()),
               seconds.proxy,
               seconds.association,
               seconds.segmentation,
               seconds.extraction,
               std::string(hit ? "OK" : "MISS")});
}

} // namespace

SectionReport runTruthSection(const BenchmarkContext &context)
{
    SurfaceOptions options;
    options.segmentation.seed = context.seed;
    if (context.runs > 0)
        options.segmentation.runs = context.runs;
    Table table(
        context.out,
        "TRUTH: synthetic sketches against the surfaces they were drawn from (% of the box diagonal; r>t "
        "result to truth, t>r truth to result)",
        columns);
    Tally tally;
    for (const SolidEntry &entry : allSolids())
        if (context.wants(entry.id))
            measure(entry.make(), options, context.quick ? 5000 : 20000, table, tally);
    char text[200];
    const int measured = std::max(1, tally.solids - table.failures());
    std::snprintf(text, sizeof text,
                  "%d of %d solids reach the target; mean of the medians %.3f %%, worst %.3f %%", tally.hits,
                  tally.solids, tally.sum / measured, tally.worst);
    table.note(text);
    return {table.json(), table.failures()};
}

} // namespace ductus
