// Algorithm 1 of thesis Sec. III.5.3 from any start and under constraints: labels and models improved in
// turns until the labels rest. segmentation.h starts it from clusters; scribbles (refinement/) start it from
// the last answer.
#pragma once

#include "surfacing/segmentation/segmentation.h"

#include <memory>

namespace ductus {

/// What is labelled: the proxy, or its simplification.
struct LabelGraph
{
    const Association &association;
    const MeshTopology &topology; // only edges and vertexEdges are used
    double totalWeight = 0.0;     // W of Eq. III.3, of the whole proxy
};

LabelGraph wholeGraph(const Association &association, const MeshTopology &topology);

/// A surface model with its cost at every vertex: D_v of Eq. III.2.
struct LabelModel
{
    int id = -1; // a name; the label, an index, changes when unused models go
    ImplicitPolynomial model;
    std::shared_ptr<const std::vector<double>> costs;
};

struct ModelLabeling
{
    std::vector<int> labels; // index into models, one a vertex; empty: none yet
    std::vector<LabelModel> models;
    int nextId = 0; // of models to come

    int labelOf(int id) const; // -1 if there is no such model
};

/// Raises the cost of models at one vertex (Eq. III.13): wanted, of all others; else, of this one.
struct VertexPreference
{
    int vertex = -1;
    int modelId = -1;
    bool isWanted = true;
    double cost = 0.0;
};

/// Takes the place of an edge's weight w^e c^e.
struct EdgeOverride
{
    int edge = -1;
    double weight = 0.0;
};

/// A model somebody asked for: improved in place and not in competition with variants of itself.
struct HeldModel
{
    int modelId = -1;
    int degree = 0; // 0: the degree of least energy
    bool isFrozen = false;
};

struct LabelConstraints
{
    std::vector<VertexPreference> preferences;
    std::vector<EdgeOverride> edges;
    std::vector<HeldModel> held;

    const HeldModel *heldModel(int modelId) const; // null if nobody holds it
};

enum class Proposals {
    Everywhere,   // as the thesis: lower degrees and merges of all regions
    WhereChanged, // only lower degrees of regions whose vertices changed, so that the rest stays as it was
    Nothing,      // only the models there are
};

LabelModel labelModel(const Association &association, ImplicitPolynomial model, int id,
                      const SegmentationOptions &options);

/// Of using a model at all: its term of w_simplicity E_simplicity (Eq. III.4).
double labelCost(const ImplicitPolynomial &model, const SegmentationOptions &options);

/// \a start needs models; iterations are told in \a iterations if given.
Result<ModelLabeling> fitModels(const LabelGraph &graph, const SegmentationOptions &options,
                                ModelLabeling start, const LabelConstraints &constraints, Proposals proposals,
                                const JobControl &control, int *iterations = nullptr);

/// Labels, used models and the energies of Eq. III.1 (without what constraints add). \a modelIds, if given:
/// one a model of the result.
Segmentation segmentationOf(const LabelGraph &graph, const SegmentationOptions &options,
                            const ModelLabeling &fit, std::vector<int> *modelIds = nullptr);

} // namespace ductus
