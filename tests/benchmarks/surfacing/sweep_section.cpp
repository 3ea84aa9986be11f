// Section "sweeps": what drawing habits and parameters do to the result. Robustness as in the thesis' Fig.
// III.15, w_simplicity (III.11), epsilon (III.12), proxy resolution (III.13), start of the segmentation
// (III.10).
#include "benchmarks/report/table.h"
#include "benchmarks/surfacing/benchmark_context.h"
#include "benchmarks/surfacing/contact_sheet.h"
#include "benchmarks/surfacing/swept_solids.h"
#include "benchmarks/surfacing/truth_scores.h"
#include "surfacing/pipeline/surface_pipeline.h"

#include <cmath>

namespace ductus {

namespace {

const std::vector<Column> columns{
    {"case", "case", 34},
    {"strokes", "strokes", 7},
    {"proxyVertices", "proxy V", 7},
    {"models", "models", 6},
    {"regions", "regions", 7},
    {"trueFaces", "true", 4},
    {"modelResidual", "model rms", 9, 3}, // stroke points to the models of their vertices
    {"resultToTruthMedian", "r>t med", 7, 3},
    {"resultToTruthP95", "p95", 6, 2},
    {"truthToResultMedian", "t>r med", 7, 3},
    {"creaseRecall", "recall", 6, 2},
    {"creasePrecision", "precis.", 7, 2},
    {"seconds", "all s", 6, 1},
};

// Where the cases of a sweep are told.
struct Report
{
    Table &table;
    ContactSheet &sheet;

    void fail(const std::string &name, const Error &error)
    {
        table.addFailure(name, error.message());
        sheet.addFailure(name);
    }
};

void measure(const std::string &name, const Solid &solid, const SketchSynthesisOptions &hand,
             const SurfaceOptions &options, Report report)
{
    const SyntheticSketch sketch = synthesizeSketch(solid, hand);
    const Result<SurfaceResult> result = surfaceSketch(sketch.strokes, std::nullopt, options, JobControl());
    if (!result)
        return report.fail(name, result.error());
    const Result<TruthScores> scores =
        scoreAgainstTruth(result->mesh, result->triangleRegions, sketch, 10000);
    if (!scores)
        return report.fail(name, scores.error());
    report.sheet.add(name, result->mesh, result->triangleRegions, sketch.strokes);
    // Eq. III.2 is the mean square distance in epsilons.
    const double residual = 100.0 * options.segmentation.epsilon * std::sqrt(result->segmentation.fidelity);
    report.table.add({name, double(sketch.strokes.strokes.size()), double(result->proxy.mesh.vertexCount()),
                      double(result->segmentation.models.size()), double(scores->regions),
                      double(solid.faceCount()), residual, scores->resultToTruth.median,
                      scores->resultToTruth.p95, scores->truthToResult.median, scores->creaseRecall,
                      scores->creasePrecision, result->timings.total});
}

std::string labelled(const Solid &solid, const char *what, double value)
{
    char text[100];
    std::snprintf(text, sizeof text, "%s: %s %g", solid.id.c_str(), what, value);
    return text;
}

// One habit at a time, the others as the default hand has them.
void sweepHabits(const Solid &solid, const SurfaceOptions &options, Report report)
{
    struct Habit
    {
        const char *name;
        double SketchSynthesisOptions::*member;
        std::vector<double> values;
    };
    const std::vector<Habit> habits{
        {"noise", &SketchSynthesisOptions::noise, {0.0, 0.003, 0.006, 0.012, 0.02}},
        {"gap probability", &SketchSynthesisOptions::gapProbability, {0.0, 0.3, 0.7}},
        {"gap length (p 0.5)", &SketchSynthesisOptions::gapLength, {0.06, 0.12}},
        {"overdraw probability", &SketchSynthesisOptions::overdrawProbability, {0.0, 0.4, 0.8}},
        {"missing share", &SketchSynthesisOptions::missingShare, {0.1, 0.2, 0.3}},
    };
    for (const Habit &habit : habits)
        for (const double value : habit.values) {
            SketchSynthesisOptions hand;
            hand.*habit.member = value;
            if (habit.member == &SketchSynthesisOptions::gapLength)
                hand.gapProbability = 0.5;
            measure(labelled(solid, habit.name, value), solid, hand, options, report);
        }
}

void sweepParameters(const Solid &solid, const SurfaceOptions &base, Report report)
{
    for (const double simplicity : {0.0, 0.001, 0.01, 0.03, 0.1}) {
        SurfaceOptions options = base;
        options.segmentation.simplicity = simplicity;
        measure(labelled(solid, "w_simplicity", simplicity), solid, {}, options, report);
    }
    for (const double epsilon : {0.0025, 0.005, 0.01, 0.02, 0.04}) {
        SurfaceOptions options = base;
        options.segmentation.epsilon = epsilon;
        measure(labelled(solid, "epsilon", epsilon), solid, {}, options, report);
    }
    for (const int vertices : {1500, 3000, 6000, 12000, 24000}) {
        SurfaceOptions options = base;
        options.proxy.targetVertices = vertices;
        measure(labelled(solid, "proxy vertices", vertices), solid, {}, options, report);
    }
}

SurfaceOptions baseOptions(const BenchmarkContext &context)
{
    SurfaceOptions options;
    options.segmentation.seed = context.seed;
    options.segmentation.runs =
        context.runs > 0 ? context.runs : 1; // many cases, and no lucky run hides a weakness
    return options;
}

using Sweep = void (*)(const Solid &, const SurfaceOptions &, Report);

SectionReport sweep(const BenchmarkContext &context, const char *name, const std::string &title, Sweep run)
{
    Table table(context.out, title, columns);
    ContactSheet sheet(context, name);
    for (const Solid &solid : sweptSolids(context))
        run(solid, baseOptions(context), {table, sheet});
    return {table.json(), table.failures() + sheet.write()};
}

} // namespace

std::vector<Solid> sweptSolids(const BenchmarkContext &context)
{
    std::vector<Solid> solids;
    for (const Solid &solid : {bevelledBox(), computerMouse()})
        if (context.wants(solid.id))
            solids.push_back(solid);
    return solids;
}

SectionReport runHabitSweeps(const BenchmarkContext &context)
{
    return sweep(context, "sweeps-habits",
                 "SWEEPS: drawing habits, one at a time (distances in % of the diagonal)", sweepHabits);
}

SectionReport runParameterSweeps(const BenchmarkContext &context)
{
    return sweep(context, "sweeps-parameters",
                 "SWEEPS: parameters, drawn by the default hand (distances in % of the diagonal)",
                 sweepParameters);
}

} // namespace ductus
