#include "surfacing/refinement/stroke_refit.h"

#include "base/parallel.h"
#include "surfacing/refinement/stroke_effect.h"
#include "surfacing/refinement/warm_start.h"

namespace ductus {

namespace {

using SharedSolution = std::shared_ptr<const LabelSolution>;

struct Candidate
{
    Result<ModelLabeling> fit = ModelLabeling();
    Segmentation segmentation;
    std::vector<int> modelIds;
    int iterations = 0;
    double energy = 0.0; // with what scribbles ask for
};

Candidate solved(const ScribbleDomain &domain, const ScribbleEffect &effect,
                 const SegmentationOptions &options, const JobControl &control)
{
    Candidate result;
    result.fit = warmStarted(domain, effect, options, control, result.iterations);
    if (!result.fit)
        return result;
    result.segmentation = segmentationOf(wholeGraph(domain.association, domain.topology), options,
                                         *result.fit, &result.modelIds);
    result.segmentation.iterations = result.iterations;
    result.energy = result.segmentation.energy;
    for (const VertexPreference &p : effect.constraints.preferences) {
        const int id = result.modelIds[std::size_t(result.segmentation.labels[std::size_t(p.vertex)])];
        if ((id == p.modelId) != p.isWanted)
            result.energy += p.cost;
    }
    return result;
}

Result<std::shared_ptr<LabelSolution>> oneRefitted(const ScribbleDomain &domain, const LabelSolution &known,
                                                   const StrokeDifference &difference,
                                                   const SegmentationOptions &options,
                                                   const JobControl &control)
{
    const StrokeEffect effect = effectOf(domain, known, difference, options);
    if (control.isCancelled())
        return cancelledError("Fitting changed strokes");
    // Expansions change one label at a time and may miss that a region is better off as two.
    Candidate candidates[2];
    parallelFor(0, effect.divided ? 2 : 1, [&](std::size_t i) {
        candidates[i] = solved(domain, i == 0 ? effect.undivided : *effect.divided, options,
                               i == 0 ? control : control.silenced());
    });
    for (const Candidate &candidate : candidates)
        if (!candidate.fit)
            return candidate.fit.error();
    const bool isDivided = effect.divided && candidates[1].energy < candidates[0].energy;
    Candidate &best = candidates[isDivided ? 1 : 0];
    auto solution = std::make_shared<LabelSolution>();
    solution->fit = std::move(*best.fit);
    solution->segmentation = std::move(best.segmentation);
    solution->segmentation.runEnergies = known.segmentation.runEnergies;
    solution->modelIds = std::move(best.modelIds);
    solution->constraints = known.constraints;
    solution->vertexIsLocked = known.vertexIsLocked;
    solution->scribbles = known.scribbles;
    return solution;
}

} // namespace

Result<SharedSolution> refitted(const ScribbleDomain &domain, const LabelSolution &known,
                                const StrokeDifference &difference, const SegmentationOptions &options,
                                const JobControl &control)
{
    const LabelSolution *automatic = &known;
    while (automatic->before)
        automatic = automatic->before.get();
    const bool hasAutomatic = automatic != &known && automatic->scribbles.empty();
    Result<std::shared_ptr<LabelSolution>> solution =
        oneRefitted(domain, known, difference, options, control.part(0.0, hasAutomatic ? 0.5 : 1.0));
    if (!solution)
        return solution.error();
    if (hasAutomatic) {
        Result<std::shared_ptr<LabelSolution>> first =
            oneRefitted(domain, *automatic, difference, options, control.part(0.5, 1.0));
        if (!first)
            return first.error();
        (*solution)->before = std::move(*first);
    }
    return SharedSolution(std::move(*solution));
}

} // namespace ductus
