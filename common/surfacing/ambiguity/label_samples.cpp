#include "surfacing/ambiguity/label_samples.h"

#include "base/parallel.h"
#include "surfacing/segmentation/graph_simplification.h"
#include "surfacing/segmentation/label_polish.h"

#include <array>
#include <cmath>
#include <optional>

namespace ductus {

namespace {

std::size_t indexOfBest(const std::vector<Segmentation> &runs)
{
    std::size_t best = 0;
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (runs[i].energy < runs[best].energy)
            best = i;
    return best;
}

// The labels of one run, and the models of all runs to choose from: a model found once is at hand when the
// parameters begin to favour it.
ModelLabeling withAllModels(const Association &association, const std::vector<Segmentation> &runs,
                            std::size_t first, const SegmentationOptions &options)
{
    ModelLabeling fit;
    fit.labels = runs[first].labels;
    std::vector<const ImplicitPolynomial *> models;
    for (const ImplicitPolynomial &model : runs[first].models)
        models.push_back(&model);
    for (std::size_t i = 0; i < runs.size(); ++i)
        for (const ImplicitPolynomial &model : runs[i].models)
            if (i != first)
                models.push_back(&model);
    fit.models.resize(models.size());
    parallelFor(0, models.size(),
                [&](std::size_t a) { fit.models[a] = labelModel(association, *models[a], int(a), options); });
    fit.nextId = int(models.size());
    return fit;
}

Result<Segmentation> changed(const Association &association, const MeshTopology &topology,
                             const std::vector<Segmentation> &runs, std::size_t best,
                             const SegmentationOptions &options, const SegmentationOptions &changedOptions,
                             const JobControl &control)
{
    const LabelGraph whole = wholeGraph(association, topology);
    const SimplifiedGraph graph = simplified(association, topology, {}, runs[best].labels, {});
    ModelLabeling start = withAllModels(graph.association, runs, best, changedOptions);
    start.labels.resize(graph.association.pointsOfVertex.size());
    for (std::size_t v = 0; v < graph.clusterOfVertex.size(); ++v)
        start.labels[std::size_t(graph.clusterOfVertex[v])] = runs[best].labels[v];
    Result<ModelLabeling> fit =
        fitModels({graph.association, graph.topology, whole.totalWeight}, changedOptions, std::move(start),
                  {}, Proposals::Everywhere, control);
    if (fit)
        fit = polished(whole, changedOptions, onWholeGraph(whole, graph, std::move(*fit), changedOptions), {},
                       control);
    if (!fit)
        return fit.error();
    for (LabelModel &model : fit->models)
        model = labelModel(association, std::move(model.model), model.id, options);
    return segmentationOf(whole, options, *fit);
}

int highestDegree(const Segmentation &segmentation)
{
    int degree = 1;
    for (const ImplicitPolynomial &model : segmentation.models)
        degree = std::max(degree, model.degree);
    return degree;
}

// The best with models of at most that degree: a bent roof, or two flat ones?
Result<Segmentation> simpler(const Association &association, const MeshTopology &topology,
                             SegmentationOptions options, int degree, int runs, const JobControl &control)
{
    options.runs = runs;
    options.maxDegree = degree;
    std::erase_if(options.initialDegrees, [&](int d) { return d > degree; });
    if (options.initialDegrees.empty())
        options.initialDegrees = {degree};
    return segment(association, topology, options, control);
}

} // namespace

Result<std::vector<LabelSample>> labelSamples(const Association &association, const MeshTopology &topology,
                                              const SegmentationOptions &options,
                                              const LabelSampleOptions &sampleOptions,
                                              const JobControl &control)
{
    SegmentationOptions runOptions = options;
    runOptions.runs = sampleOptions.runs;
    const Result<std::vector<Segmentation>> runs =
        segmentationRuns(association, topology, runOptions, control.part(0.0, 0.7));
    if (!runs)
        return runs.error();
    const std::size_t best = indexOfBest(*runs);

    const double f = sampleOptions.parameterFactor;
    std::array<SegmentationOptions, 4> variants = {options, options, options, options};
    variants[0].epsilon *= f;
    variants[1].epsilon /= f;
    variants[2].simplicity *= f;
    variants[3].simplicity /= f;
    const std::size_t lower = std::size_t(std::min(highestDegree((*runs)[best]), options.maxDegree) - 1);
    std::vector<std::optional<Result<Segmentation>>> answers(variants.size() + lower);
    const JobControl otherControl = control.part(0.7, 1.0);
    parallelFor(0, answers.size(), [&](std::size_t i) {
        const JobControl mine = i == 0 ? otherControl : otherControl.silenced();
        answers[i] = i < variants.size()
                         ? changed(association, topology, *runs, best, options, variants[i], mine)
                         : simpler(association, topology, options, int(i - variants.size()) + 1,
                                   sampleOptions.simplerRuns, mine);
    });

    const double least = (*runs)[best].energy;
    const auto plausibility = [&](const Segmentation &s) {
        return s.energy > least ? std::exp((least - s.energy) / (sampleOptions.temperature * least)) : 1.0;
    };
    std::vector<LabelSample> samples;
    for (const Segmentation &run : *runs)
        samples.push_back({run, plausibility(run)});
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (!answers[i]->ok())
            return answers[i]->error();
        Segmentation &answer = **answers[i];
        const double weight = i < variants.size() ? 1.0 : plausibility(answer);
        samples.push_back({std::move(answer), weight});
    }
    return samples;
}

} // namespace ductus
