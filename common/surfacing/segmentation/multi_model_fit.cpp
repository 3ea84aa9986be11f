#include "surfacing/segmentation/multi_model_fit.h"

#include "base/parallel.h"
#include "numeric/alpha_expansion.h"
#include "surfacing/segmentation/data_costs.h"
#include "surfacing/segmentation/proposals.h"
#include "surfacing/segmentation/region_fit.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace ductus {

namespace {

// One run of Algorithm 1.
class Pearl
{
public:
    Pearl(const LabelGraph &graph, const SegmentationOptions &options, const LabelConstraints &constraints,
          Proposals proposals)
        : mAssociation(graph.association), mTopology(graph.topology), mOptions(options),
          mConstraints(constraints), mProposals(proposals)
    {
        std::vector<double> weights = mAssociation.edgeWeights;
        for (const EdgeOverride &o : constraints.edges)
            weights[std::size_t(o.edge)] = o.weight;
        mEdges.reserve(mTopology.edges.size());
        for (std::size_t e = 0; e < mTopology.edges.size(); ++e)
            mEdges.push_back({mTopology.edges[e].v0, mTopology.edges[e].v1,
                              options.smoothness * weights[e] / graph.totalWeight});
    }

    Result<ModelLabeling> run(ModelLabeling start, const JobControl &control, int &iterations)
    {
        mFit = std::move(start);
        for (const LabelModel &model : mFit.models)
            mCosts.push_back(costsWithPreferences(model));
        TriedMerges tried;
        for (int iteration = 1; iteration <= mOptions.maxIterations; ++iteration) {
            if (control.isCancelled())
                return cancelledError("Segmenting the surface");
            control.progress(double(iteration - 1) / 8.0, "Finding surface patches");
            const std::vector<int> previous = mFit.labels;
            const Result<Labeling> labeling = optimizeLabels(control);
            if (!labeling)
                return labeling.error();
            mFit.labels = labeling->labels;
            iterations = iteration;
            if (mFit.labels == previous)
                break;
            const std::vector<char> changed = changedModels(previous);
            removeUnusedModels();
            refitModels(changed);
            propose(changed, tried);
        }
        removeUnusedModels();
        return std::move(mFit);
    }

private:
    using Costs = std::shared_ptr<const std::vector<double>>;

    Costs costsWithPreferences(const LabelModel &model) const
    {
        if (mConstraints.preferences.empty())
            return model.costs;
        std::vector<double> costs = *model.costs;
        for (const VertexPreference &p : mConstraints.preferences)
            if ((p.modelId == model.id) != p.isWanted)
                costs[std::size_t(p.vertex)] += p.cost;
        return std::make_shared<const std::vector<double>>(std::move(costs));
    }

    void addModels(std::vector<ImplicitPolynomial> models)
    {
        const std::size_t first = mFit.models.size();
        mFit.models.resize(first + models.size());
        mCosts.resize(first + models.size());
        parallelFor(0, models.size(), [&](std::size_t i) {
            LabelModel &added = mFit.models[first + i];
            added = labelModel(mAssociation, std::move(models[i]), mFit.nextId + int(i), mOptions);
            mCosts[first + i] = costsWithPreferences(added);
        });
        mFit.nextId += int(models.size());
    }

    Result<Labeling> optimizeLabels(const JobControl &control) const
    {
        LabelingProblem problem;
        problem.vertexCount = int(mAssociation.pointsOfVertex.size());
        problem.edges = mEdges;
        for (std::size_t a = 0; a < mFit.models.size(); ++a) {
            problem.dataCosts.push_back(*mCosts[a]);
            problem.labelCosts.push_back(labelCost(mFit.models[a].model, mOptions));
        }
        return alphaExpansion(problem, {}, mFit.labels, control.silenced()); // an iteration is one step
    }

    // By label: did any vertex join or leave since \a previous?
    std::vector<char> changedModels(const std::vector<int> &previous) const
    {
        std::vector<char> changed(mFit.models.size(), previous.empty());
        for (std::size_t v = 0; v < previous.size(); ++v)
            if (previous[v] != mFit.labels[v])
                changed[std::size_t(previous[v])] = changed[std::size_t(mFit.labels[v])] = 1;
        std::vector<char> used(mFit.models.size(), 0);
        for (int label : mFit.labels)
            used[std::size_t(label)] = 1;
        // In the numbers removeUnusedModels gives.
        std::vector<char> ofUsed;
        for (std::size_t a = 0; a < used.size(); ++a)
            if (used[a])
                ofUsed.push_back(changed[a]);
        return ofUsed;
    }

    // Used models come first, then the held ones that nobody uses at the moment.
    void removeUnusedModels()
    {
        std::vector<int> newFromOld(mFit.models.size(), -1);
        for (int label : mFit.labels)
            newFromOld[std::size_t(label)] = 0;
        std::vector<LabelModel> kept;
        std::vector<Costs> keptCosts;
        const auto keep = [&](std::size_t a) {
            newFromOld[a] = int(kept.size());
            kept.push_back(std::move(mFit.models[a]));
            keptCosts.push_back(std::move(mCosts[a]));
        };
        std::vector<std::size_t> heldOnly;
        for (std::size_t a = 0; a < mFit.models.size(); ++a) {
            if (newFromOld[a] == 0)
                keep(a);
            else if (mConstraints.heldModel(mFit.models[a].id))
                heldOnly.push_back(a);
        }
        mUsedCount = kept.size();
        for (std::size_t a : heldOnly)
            keep(a);
        mFit.models = std::move(kept);
        mCosts = std::move(keptCosts);
        for (int &label : mFit.labels)
            label = newFromOld[std::size_t(label)];
    }

    RegionSupport supportOfLabel(std::size_t a) const
    {
        std::vector<char> flags(mFit.labels.size());
        for (std::size_t v = 0; v < mFit.labels.size(); ++v)
            flags[v] = mFit.labels[v] == int(a);
        return supportOf(mAssociation, flags);
    }

    double costOfLabel(std::size_t a, const std::vector<double> &costs) const
    {
        double sum = 0.0;
        for (std::size_t v = 0; v < mFit.labels.size(); ++v)
            if (mFit.labels[v] == int(a))
                sum += costs[v];
        return sum;
    }

    // A refit replaces its model only if the fidelity of its vertices falls; else it becomes one more
    // candidate.
    void refitModels(const std::vector<char> &changed)
    {
        std::vector<std::optional<LabelModel>> refits(mUsedCount);
        parallelFor(0, mUsedCount, [&](std::size_t a) {
            const HeldModel *held = mConstraints.heldModel(mFit.models[a].id);
            if ((held && held->isFrozen) || (mProposals != Proposals::Everywhere && !changed[a]))
                return;
            const RegionSupport support = supportOfLabel(a);
            if (support.points.empty())
                return;
            const int degree = mFit.models[a].model.degree;
            if (held)
                refits[a] = bestVariant(a, support, held->degree ? held->degree : 1,
                                        held->degree ? held->degree : mOptions.maxDegree);
            else
                refits[a] = labelModel(mAssociation, fitRegion(mAssociation, support, degree, mOptions.fit),
                                       mFit.models[a].id, mOptions);
        });
        for (std::size_t a = 0; a < mUsedCount; ++a) {
            if (!refits[a])
                continue;
            const bool isHeld = mConstraints.heldModel(mFit.models[a].id);
            const double before = costOfLabel(a, *mFit.models[a].costs);
            const double after = costOfLabel(a, *refits[a]->costs);
            const double labelCostBefore = isHeld ? labelCost(mFit.models[a].model, mOptions) : 0.0;
            const double labelCostAfter = isHeld ? labelCost(refits[a]->model, mOptions) : 0.0;
            if (after + labelCostAfter < before + labelCostBefore) {
                mCosts[a] = costsWithPreferences(*refits[a]);
                mFit.models[a] = std::move(*refits[a]);
            } else if (!isHeld) {
                refits[a]->id = mFit.nextId++;
                mCosts.push_back(costsWithPreferences(*refits[a]));
                mFit.models.push_back(std::move(*refits[a]));
            }
        }
    }

    // The degree of least energy for the vertices the label has now.
    LabelModel bestVariant(std::size_t a, const RegionSupport &support, int lowest, int highest) const
    {
        std::optional<LabelModel> best;
        double bestEnergy = 0.0;
        for (int degree = lowest; degree <= highest; ++degree) {
            LabelModel variant =
                labelModel(mAssociation, fitRegion(mAssociation, support, degree, mOptions.fit),
                           mFit.models[a].id, mOptions);
            const double energy = costOfLabel(a, *variant.costs) + labelCost(variant.model, mOptions);
            if (!best || energy < bestEnergy) {
                best = std::move(variant);
                bestEnergy = energy;
            }
        }
        return std::move(*best);
    }

    void propose(const std::vector<char> &changed, TriedMerges &tried)
    {
        if (mProposals == Proposals::Everywhere) {
            std::vector<ImplicitPolynomial> models;
            for (std::size_t a = 0; a < mUsedCount; ++a)
                models.push_back(mFit.models[a].model);
            addModels(proposeModels(mAssociation, mTopology, mFit.labels, models, mOptions, tried));
            return;
        }
        if (mProposals == Proposals::Nothing)
            return;
        std::vector<ImplicitPolynomial> lower;
        for (std::size_t a = 0; a < mUsedCount; ++a) {
            if (!changed[a] || mConstraints.heldModel(mFit.models[a].id))
                continue;
            const RegionSupport support = supportOfLabel(a);
            for (int degree = mFit.models[a].model.degree - 1; degree >= 1 && !support.points.empty();
                 --degree)
                lower.push_back(fitRegion(mAssociation, support, degree, mOptions.fit));
        }
        addModels(std::move(lower));
    }

    const Association &mAssociation;
    const MeshTopology &mTopology;
    const SegmentationOptions &mOptions;
    const LabelConstraints &mConstraints;
    const Proposals mProposals;
    std::vector<LabelingEdge> mEdges;
    ModelLabeling mFit;        // the used models first, then what was proposed
    std::vector<Costs> mCosts; // beside mFit.models: with preferences
    std::size_t mUsedCount = 0;
};

} // namespace

int ModelLabeling::labelOf(int id) const
{
    for (std::size_t a = 0; a < models.size(); ++a)
        if (models[a].id == id)
            return int(a);
    return -1;
}

LabelGraph wholeGraph(const Association &association, const MeshTopology &topology)
{
    return {association, topology,
            std::accumulate(association.edgeWeights.begin(), association.edgeWeights.end(), 0.0)};
}

const HeldModel *LabelConstraints::heldModel(int modelId) const
{
    for (const HeldModel &model : held)
        if (model.modelId == modelId)
            return &model;
    return nullptr;
}

LabelModel labelModel(const Association &association, ImplicitPolynomial model, int id,
                      const SegmentationOptions &options)
{
    auto costs = std::make_shared<const std::vector<double>>(
        dataCosts(association, model, options.epsilon, options.proxyPrior));
    return {id, std::move(model), std::move(costs)};
}

double labelCost(const ImplicitPolynomial &model, const SegmentationOptions &options)
{
    return options.simplicity * double(model.theta.size()) / options.parameterNormaliser;
}

Result<ModelLabeling> fitModels(const LabelGraph &graph, const SegmentationOptions &options,
                                ModelLabeling start, const LabelConstraints &constraints, Proposals proposals,
                                const JobControl &control, int *iterations)
{
    int count = 0;
    Pearl pearl(graph, options, constraints, proposals);
    Result<ModelLabeling> fit = pearl.run(std::move(start), control, count);
    if (iterations)
        *iterations = count;
    return fit;
}

Segmentation segmentationOf(const LabelGraph &graph, const SegmentationOptions &options,
                            const ModelLabeling &fit, std::vector<int> *modelIds)
{
    Segmentation result;
    std::vector<int> newFromOld(fit.models.size(), -1);
    for (int label : fit.labels)
        newFromOld[std::size_t(label)] = 0;
    if (modelIds)
        modelIds->clear();
    for (std::size_t a = 0; a < fit.models.size(); ++a) {
        if (newFromOld[a] < 0)
            continue;
        newFromOld[a] = int(result.models.size());
        result.models.push_back(fit.models[a].model);
        if (modelIds)
            modelIds->push_back(fit.models[a].id);
    }
    for (std::size_t v = 0; v < fit.labels.size(); ++v) {
        const std::size_t old = std::size_t(fit.labels[v]);
        result.labels.push_back(newFromOld[old]);
        result.fidelity += (*fit.models[old].costs)[v];
    }
    const std::vector<MeshEdge> &edges = graph.topology.edges;
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (result.labels[std::size_t(edges[e].v0)] != result.labels[std::size_t(edges[e].v1)])
            result.smoothness += graph.association.edgeWeights[e] / graph.totalWeight;
    for (const ImplicitPolynomial &model : result.models)
        result.simplicity += double(model.theta.size()) / options.parameterNormaliser;
    result.energy =
        result.fidelity + options.smoothness * result.smoothness + options.simplicity * result.simplicity;
    return result;
}

} // namespace ductus
