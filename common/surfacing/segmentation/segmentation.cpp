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
        start.models[i] = labelModel(graph.association, std::move(models[i]), int(i), options.epsilon);
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

// The best of several runs; \a energies receives one a run.
Result<Run> bestRun(const LabelGraph &graph, const SegmentationOptions &options, const JobControl &control,
                    std::vector<double> &energies)
{
    const Result<Eigen::MatrixXd> embedding =
        proxyEmbedding(graph.association, graph.topology, options, control.part(0.0, 0.2));
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
    std::size_t best = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (!runs[i]->ok())
            return runs[i]->error();
        energies.push_back((*runs[i])->energy);
        if (energies[i] < energies[best])
            best = i;
    }
    return std::move(**runs[best]);
}

} // namespace

Result<Segmentation> segment(const Association &association, const MeshTopology &topology,
                             const SegmentationOptions &options, const JobControl &control)
{
    const LabelGraph whole = wholeGraph(association, topology);
    std::vector<double> energies;
    Segmentation segmentation;
    if (options.simplifyGraph) {
        const SimplifiedGraph graph = simplified(association, topology, {}, {}, {});
        Result<Run> best = bestRun({graph.association, graph.topology, whole.totalWeight}, options,
                                   control.part(0.0, 0.9), energies);
        if (!best)
            return best.error();
        const Result<ModelLabeling> fit =
            polished(whole, options, onWholeGraph(whole, graph, std::move(best->fit), options), {},
                     control.part(0.9, 1.0));
        if (!fit)
            return fit.error();
        segmentation = segmentationOf(whole, options, *fit);
        segmentation.iterations = best->iterations;
    } else {
        const Result<Run> best = bestRun(whole, options, control, energies);
        if (!best)
            return best.error();
        segmentation = segmentationOf(whole, options, best->fit);
        segmentation.iterations = best->iterations;
    }
    segmentation.runEnergies = std::move(energies);
    return segmentation;
}

} // namespace ductus
