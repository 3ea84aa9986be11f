#include "surfacing/segmentation/segmentation.h"

#include "base/parallel.h"
#include "surfacing/segmentation/graph_simplification.h"
#include "surfacing/segmentation/initial_models.h"
#include "surfacing/segmentation/label_polish.h"

#include <Eigen/Core>
#include <algorithm>
#include <optional>

namespace ductus {

namespace {

struct Run
{
    ModelLabeling fit;
    double energy = 0.0;
    int iterations = 0;
};

Result<Run> oneRun(const LabelGraph &graph, std::vector<ImplicitPolynomial> models,
                   const SegmentationOptions &options, const JobControl &control)
{
    ModelLabeling start;
    start.nextId = int(models.size());
    start.models.resize(models.size());
    parallelFor(0, models.size(), [&](std::size_t i) {
        start.models[i] = labelModel(graph.association, std::move(models[i]), int(i), options);
    });
    Run run;
    Result<ModelLabeling> fit =
        fitModels(graph, options, std::move(start), {}, Proposals::Everywhere, control, &run.iterations);
    if (!fit)
        return fit.error();
    run.energy = segmentationOf(graph, options, *fit).energy;
    run.fit = std::move(*fit);
    return run;
}

Result<std::vector<Run>> allRuns(const LabelGraph &graph, const SegmentationOptions &options,
                                 const JobControl &control)
{
    control.progress(0.0, "Finding surface patches");
    const Result<Eigen::MatrixXd> embedding =
        proxyEmbedding(graph.association, graph.topology, options, control.silenced());
    if (!embedding)
        return embedding.error();
    std::vector<std::optional<Result<Run>>> runs(std::size_t(std::max(options.runs, 1)));
    parallelFor(0, runs.size(), [&](std::size_t i) {
        const Random random = Random(options.seed).fork(i);
        // Progress of parallel runs would jump about: only the first one tells it.
        const JobControl runControl = i == 0 ? control.part(0.2, 1.0) : control.silenced();
        runs[i] =
            oneRun(graph, initialModels(graph.association, *embedding, options, random), options, runControl);
    });
    std::vector<Run> done;
    for (std::optional<Result<Run>> &run : runs) {
        if (!run->ok())
            return run->error();
        done.push_back(std::move(**run));
    }
    return done;
}

std::size_t indexOfBest(const std::vector<Run> &runs)
{
    std::size_t best = 0;
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (runs[i].energy < runs[best].energy)
            best = i;
    return best;
}

// What the runs label: the proxy, or its simplification and the way back.
struct RunGraph
{
    RunGraph(const Association &association, const MeshTopology &topology, bool simplify)
        : whole(wholeGraph(association, topology))
    {
        if (simplify)
            simple = simplified(association, topology, {}, {}, {});
    }

    LabelGraph labelled() const
    {
        return simple ? LabelGraph{simple->association, simple->topology, whole.totalWeight} : whole;
    }

    Result<Segmentation> finished(Run run, const SegmentationOptions &options,
                                  const JobControl &control) const
    {
        if (simple) {
            Result<ModelLabeling> fit = polished(
                whole, options, onWholeGraph(whole, *simple, std::move(run.fit), options), {}, control);
            if (!fit)
                return fit.error();
            run.fit = std::move(*fit);
        }
        Segmentation segmentation = segmentationOf(whole, options, run.fit);
        segmentation.iterations = run.iterations;
        return segmentation;
    }

    LabelGraph whole;
    std::optional<SimplifiedGraph> simple;
};

} // namespace

Result<Segmentation> segment(const Association &association, const MeshTopology &topology,
                             const SegmentationOptions &options, const JobControl &control)
{
    const RunGraph graph(association, topology, options.simplifyGraph);
    Result<std::vector<Run>> runs = allRuns(graph.labelled(), options, control.part(0.0, 0.9));
    if (!runs)
        return runs.error();
    std::vector<double> energies;
    for (const Run &run : *runs)
        energies.push_back(run.energy);
    Result<Segmentation> best =
        graph.finished(std::move((*runs)[indexOfBest(*runs)]), options, control.part(0.9, 1.0));
    if (best)
        best->runEnergies = std::move(energies);
    return best;
}

Result<std::vector<Segmentation>> segmentationRuns(const Association &association,
                                                   const MeshTopology &topology,
                                                   const SegmentationOptions &options,
                                                   const JobControl &control)
{
    const RunGraph graph(association, topology, options.simplifyGraph);
    Result<std::vector<Run>> runs = allRuns(graph.labelled(), options, control.part(0.0, 0.8));
    if (!runs)
        return runs.error();
    std::vector<std::optional<Result<Segmentation>>> finished(runs->size());
    parallelFor(0, runs->size(), [&](std::size_t i) {
        finished[i] = graph.finished(std::move((*runs)[i]), options, control.silenced());
    });
    std::vector<Segmentation> result;
    for (std::optional<Result<Segmentation>> &one : finished) {
        if (!one->ok())
            return one->error();
        result.push_back(std::move(**one));
    }
    return result;
}

} // namespace ductus
