#include "surfacing/segmentation/segmentation.h"

#include "base/parallel.h"
#include "numeric/alpha_expansion.h"
#include "surfacing/segmentation/data_costs.h"
#include "surfacing/segmentation/initial_models.h"
#include "surfacing/segmentation/proposals.h"

#include <Eigen/Core>
#include <algorithm>
#include <numeric>
#include <optional>

namespace ductus {

namespace {

// One run of Algorithm 1.
class Pearl
{
public:
    Pearl(const Association &association, const MeshTopology &topology, const SegmentationOptions &options)
        : mAssociation(association), mTopology(topology), mOptions(options)
    {
        mTotalWeight = std::accumulate(association.edgeWeights.begin(), association.edgeWeights.end(), 0.0);
        mEdges.reserve(topology.edges.size());
        for (std::size_t e = 0; e < topology.edges.size(); ++e)
            mEdges.push_back({topology.edges[e].v0, topology.edges[e].v1,
                              options.smoothness * association.edgeWeights[e] / mTotalWeight});
    }

    Result<Segmentation> run(std::vector<ImplicitPolynomial> firstModels, const JobControl &control)
    {
        addModels(std::move(firstModels));
        TriedMerges tried;
        Segmentation result;
        for (int iteration = 1; iteration <= mOptions.maxIterations; ++iteration) {
            if (control.isCancelled())
                return cancelledError("Segmenting the surface");
            control.progress(double(iteration - 1) / 8.0, "Finding surface patches");
            const std::vector<int> previous = mLabels;
            const Result<Labeling> labeling = optimizeLabels(control);
            if (!labeling)
                return labeling.error();
            mLabels = labeling->labels;
            result.iterations = iteration;
            if (mLabels == previous)
                break;
            removeUnusedModels();
            refitModels();
            addModels(proposeModels(mAssociation, mTopology, mLabels, usedModels(), mOptions, tried));
        }
        removeUnusedModels();
        result.labels = mLabels;
        result.models = usedModels();
        measure(result);
        return result;
    }

private:
    struct Candidate
    {
        ImplicitPolynomial model;
        std::vector<double> costs; // D_v of this model for every vertex
    };

    void addModels(std::vector<ImplicitPolynomial> models)
    {
        const std::size_t first = mCandidates.size();
        mCandidates.resize(first + models.size());
        parallelFor(0, models.size(), [&](std::size_t i) {
            mCandidates[first + i].costs = dataCosts(mAssociation, models[i], mOptions.epsilon);
            mCandidates[first + i].model = std::move(models[i]);
        });
    }

    Result<Labeling> optimizeLabels(const JobControl &control) const
    {
        LabelingProblem problem;
        problem.vertexCount = int(mAssociation.pointsOfVertex.size());
        problem.edges = mEdges;
        for (const Candidate &c : mCandidates) {
            problem.dataCosts.push_back(c.costs);
            problem.labelCosts.push_back(labelCost(c.model));
        }
        return alphaExpansion(problem, {}, mLabels, control);
    }

    double labelCost(const ImplicitPolynomial &model) const
    {
        return mOptions.simplicity * double(model.theta.size()) / mOptions.parameterNormaliser;
    }

    void removeUnusedModels()
    {
        std::vector<int> newFromOld(mCandidates.size(), -1);
        for (int label : mLabels)
            newFromOld[std::size_t(label)] = 0;
        std::vector<Candidate> kept;
        for (std::size_t a = 0; a < mCandidates.size(); ++a)
            if (newFromOld[a] == 0) {
                newFromOld[a] = int(kept.size());
                kept.push_back(std::move(mCandidates[a]));
            }
        mCandidates = std::move(kept);
        mUsedCount = mCandidates.size();
        for (int &label : mLabels)
            label = newFromOld[std::size_t(label)];
    }

    // A refit replaces its model only if the fidelity of its vertices falls; else it becomes one more candidate.
    void refitModels()
    {
        std::vector<std::optional<Candidate>> refits(mUsedCount);
        parallelFor(0, mUsedCount, [&](std::size_t a) {
            std::vector<char> flags(mLabels.size());
            for (std::size_t v = 0; v < mLabels.size(); ++v)
                flags[v] = mLabels[v] == int(a);
            const std::vector<int> points = pointsOf(mAssociation, flags);
            if (points.empty())
                return;
            Candidate refit;
            refit.model = fitPolynomial(mAssociation.points, points, mCandidates[a].model.degree, mOptions.fit);
            refit.costs = dataCosts(mAssociation, refit.model, mOptions.epsilon);
            refits[a] = std::move(refit);
        });
        for (std::size_t a = 0; a < mUsedCount; ++a) {
            if (!refits[a])
                continue;
            double before = 0.0, after = 0.0;
            for (std::size_t v = 0; v < mLabels.size(); ++v)
                if (mLabels[v] == int(a)) {
                    before += mCandidates[a].costs[v];
                    after += refits[a]->costs[v];
                }
            if (after < before)
                mCandidates[a] = std::move(*refits[a]);
            else
                mCandidates.push_back(std::move(*refits[a]));
        }
    }

    std::vector<ImplicitPolynomial> usedModels() const
    {
        std::vector<ImplicitPolynomial> models;
        for (std::size_t a = 0; a < mUsedCount; ++a)
            models.push_back(mCandidates[a].model);
        return models;
    }

    void measure(Segmentation &result) const
    {
        for (std::size_t v = 0; v < mLabels.size(); ++v)
            result.fidelity += mCandidates[std::size_t(mLabels[v])].costs[v];
        for (std::size_t e = 0; e < mEdges.size(); ++e)
            if (mLabels[std::size_t(mEdges[e].u)] != mLabels[std::size_t(mEdges[e].v)])
                result.smoothness += mAssociation.edgeWeights[e] / mTotalWeight;
        for (const ImplicitPolynomial &model : result.models)
            result.simplicity += double(model.theta.size()) / mOptions.parameterNormaliser;
        result.energy = result.fidelity + mOptions.smoothness * result.smoothness +
                        mOptions.simplicity * result.simplicity;
    }

    const Association &mAssociation;
    const MeshTopology &mTopology;
    const SegmentationOptions &mOptions;
    double mTotalWeight = 0.0; // W of Eq. III.3
    std::vector<LabelingEdge> mEdges;
    std::vector<Candidate> mCandidates; // the used ones first, then what was proposed
    std::size_t mUsedCount = 0;
    std::vector<int> mLabels; // empty before the first iteration
};

} // namespace

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
        Pearl pearl(association, topology, options);
        // Progress of parallel runs would jump about: only the first one tells it.
        const JobControl runControl = run == 0 ? control.part(0.2, 1.0) : control.silenced();
        results[run] = pearl.run(initialModels(association, *embedding, options, random), runControl);
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
