#include "surfacing/segmentation/segmentation.h"

#include "base/parallel.h"
#include "surfacing/segmentation/initial_models.h"
#include "surfacing/segmentation/multi_model_fit.h"

#include <Eigen/Core>
#include <algorithm>
#include <optional>

namespace ductus {

Result<Segmentation> segment(const Association &association, const MeshTopology &topology,
                             const SegmentationOptions &options, const JobControl &control)
{
    const Result<Eigen::MatrixXd> embedding =
        proxyEmbedding(association, topology, options, control.part(0.0, 0.2));
    if (!embedding)
        return embedding.error();

    const std::size_t runs = std::size_t(std::max(options.runs, 1));
    std::vector<std::optional<Result<Segmentation>>> results(runs);
    parallelFor(0, runs, [&](std::size_t run) {
        const Random random = Random(options.seed).fork(run);
        ModelLabeling start;
        std::vector<ImplicitPolynomial> models = initialModels(association, *embedding, options, random);
        start.nextId = int(models.size());
        start.models.resize(models.size());
        parallelFor(0, models.size(), [&](std::size_t i) {
            start.models[i] = labelModel(association, std::move(models[i]), int(i), options.epsilon);
        });
        // Progress of parallel runs would jump about: only the first one tells it.
        const JobControl runControl = run == 0 ? control.part(0.2, 1.0) : control.silenced();
        int iterations = 0;
        const Result<ModelLabeling> fit = fitModels(association, topology, options, std::move(start), {},
                                                    Proposals::Everywhere, runControl, &iterations);
        if (!fit) {
            results[run] = fit.error();
            return;
        }
        Segmentation segmentation = segmentationOf(association, topology, options, *fit);
        segmentation.iterations = iterations;
        results[run] = std::move(segmentation);
    });

    std::size_t best = 0;
    std::vector<double> energies;
    for (std::size_t run = 0; run < runs; ++run) {
        if (!results[run]->ok())
            return results[run]->error();
        energies.push_back((*results[run])->energy);
        if (energies[run] < energies[best])
            best = run;
    }
    Segmentation segmentation = std::move(**results[best]);
    segmentation.runEnergies = std::move(energies);
    return segmentation;
}

} // namespace ductus
