#include "surfacing/refinement/refinement.h"

#include "surfacing/refinement/warm_start.h"

namespace ductus {

namespace {

using SharedSolution = std::shared_ptr<const LabelSolution>;

Result<SharedSolution> automaticSolution(const ScribbleDomain &domain, const SegmentationOptions &options,
                                         const JobControl &control)
{
    Result<Segmentation> segmentation = segment(domain.association, domain.topology, options, control);
    if (!segmentation)
        return segmentation.error();
    return SharedSolution(
        std::make_shared<const LabelSolution>(unscribbled(domain, std::move(*segmentation), options)));
}

Result<SharedSolution> applied(const ScribbleDomain &domain, const SharedSolution &before,
                               const Scribble &scribble, const SegmentationOptions &options,
                               const JobControl &control)
{
    Result<ScribbleEffect> effect = effectOf(domain, *before, scribble, options);
    if (!effect)
        return effect.error();
    int iterations = 0;
    Result<ModelLabeling> fit = warmStarted(domain, *effect, options, control, iterations);
    if (!fit)
        return fit.error();
    auto solution = std::make_shared<LabelSolution>();
    solution->fit = std::move(*fit);
    solution->segmentation = segmentationOf(wholeGraph(domain.association, domain.topology), options,
                                            solution->fit, &solution->modelIds);
    solution->segmentation.iterations = iterations;
    solution->segmentation.runEnergies = before->segmentation.runEnergies;
    solution->constraints = std::move(effect->constraints);
    solution->vertexIsLocked = std::move(effect->vertexIsLocked);
    solution->scribbles = before->scribbles;
    solution->scribbles.push_back(scribble);
    solution->before = before;
    return SharedSolution(std::move(solution));
}

bool startsWith(const std::vector<Scribble> &all, const std::vector<Scribble> &first)
{
    return first.size() <= all.size() && std::equal(first.begin(), first.end(), all.begin());
}

} // namespace

LabelSolution unscribbled(const ScribbleDomain &domain, Segmentation segmentation,
                          const SegmentationOptions &options)
{
    LabelSolution solution;
    solution.vertexIsLocked.assign(segmentation.labels.size(), 0);
    solution.fit.labels = segmentation.labels;
    for (const ImplicitPolynomial &model : segmentation.models) {
        solution.modelIds.push_back(solution.fit.nextId);
        solution.fit.models.push_back(labelModel(domain.association, model, solution.fit.nextId++, options));
    }
    solution.segmentation = std::move(segmentation);
    return solution;
}

Result<SharedSolution> refine(const ScribbleDomain &domain, const SharedSolution &known,
                              const std::vector<Scribble> &scribbles, const SegmentationOptions &options,
                              const JobControl &control)
{
    SharedSolution solution = known;
    while (solution && !startsWith(scribbles, solution->scribbles))
        solution = solution->before;
    const double share = solution || scribbles.empty() ? (scribbles.empty() ? 1.0 : 0.0) : 0.8;
    if (!solution) {
        Result<SharedSolution> automatic = automaticSolution(domain, options, control.part(0.0, share));
        if (!automatic)
            return automatic;
        solution = std::move(*automatic);
    }
    const std::size_t first = solution->scribbles.size();
    const double step = (1.0 - share) / double(std::max<std::size_t>(scribbles.size() - first, 1));
    for (std::size_t i = first; i < scribbles.size(); ++i) {
        const double begin = share + step * double(i - first);
        Result<SharedSolution> next =
            applied(domain, solution, scribbles[i], options, control.part(begin, begin + step));
        if (!next) {
            Error error = next.error();
            if (error.place.empty() && !error.isCancelled())
                error.place = "scribble " + std::to_string(i);
            return error;
        }
        solution = std::move(*next);
    }
    return solution;
}

} // namespace ductus
