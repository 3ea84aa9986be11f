#include "surfacing/refinement/warm_start.h"

#include "surfacing/segmentation/label_polish.h"

#include <algorithm>
#include <map>

namespace ductus {

namespace {

// Vertices a constraint names one by one; joined with others they could not be told apart. Preferences
// against a model and locks hold for whole regions and add up over a cluster.
std::vector<char> keptVertices(const ScribbleDomain &domain, const ScribbleEffect &effect)
{
    std::vector<char> kept(effect.start.labels.size(), 0);
    for (const VertexPreference &p : effect.constraints.preferences)
        if (p.isWanted && !effect.vertexIsLocked[std::size_t(p.vertex)])
            kept[std::size_t(p.vertex)] = 1;
    for (const EdgeOverride &o : effect.constraints.edges) {
        const MeshEdge &edge = domain.topology.edges[std::size_t(o.edge)];
        kept[std::size_t(edge.v0)] = kept[std::size_t(edge.v1)] = 1;
    }
    return kept;
}

ModelLabeling onClusters(const SimplifiedGraph &graph, const ModelLabeling &whole)
{
    ModelLabeling result;
    result.nextId = whole.nextId;
    const std::size_t count = graph.association.pointsOfVertex.size();
    result.labels.resize(count);
    for (std::size_t v = 0; v < graph.clusterOfVertex.size(); ++v)
        result.labels[std::size_t(graph.clusterOfVertex[v])] = whole.labels[v];
    for (const LabelModel &model : whole.models) {
        std::vector<double> costs(count, 0.0);
        for (std::size_t v = 0; v < graph.clusterOfVertex.size(); ++v)
            costs[std::size_t(graph.clusterOfVertex[v])] += (*model.costs)[v];
        result.models.push_back(
            {model.id, model.model, std::make_shared<const std::vector<double>>(std::move(costs))});
    }
    return result;
}

LabelConstraints onClusters(const SimplifiedGraph &graph, const ScribbleDomain &domain,
                            const LabelConstraints &whole)
{
    LabelConstraints result;
    result.held = whole.held;
    for (const VertexPreference &p : whole.preferences)
        result.preferences.push_back(
            {graph.clusterOfVertex[std::size_t(p.vertex)], p.modelId, p.isWanted, p.cost});
    std::map<std::pair<int, int>, int> edgeOf;
    for (std::size_t e = 0; e < graph.topology.edges.size(); ++e)
        edgeOf[{graph.topology.edges[e].v0, graph.topology.edges[e].v1}] = int(e);
    for (const EdgeOverride &o : whole.edges) {
        const MeshEdge &edge = domain.topology.edges[std::size_t(o.edge)];
        const int u = graph.clusterOfVertex[std::size_t(edge.v0)],
                  v = graph.clusterOfVertex[std::size_t(edge.v1)];
        result.edges.push_back({edgeOf.at(std::minmax(u, v)), o.weight});
    }
    return result;
}

} // namespace

Result<ModelLabeling> warmStarted(const ScribbleDomain &domain, ScribbleEffect effect,
                                  const SegmentationOptions &options, const JobControl &control,
                                  int &iterations)
{
    const LabelGraph whole = wholeGraph(domain.association, domain.topology);
    if (!options.simplifyGraph)
        return fitModels(whole, options, std::move(effect.start), effect.constraints, Proposals::WhereChanged,
                         control, &iterations);
    const SimplifiedGraph graph = simplified(domain.association, domain.topology,
                                             keptVertices(domain, effect), effect.start.labels, {});
    Result<ModelLabeling> fit =
        fitModels({graph.association, graph.topology, whole.totalWeight}, options,
                  onClusters(graph, effect.start), onClusters(graph, domain, effect.constraints),
                  Proposals::WhereChanged, control.part(0.0, 0.8), &iterations);
    if (!fit)
        return fit;
    return polished(whole, options, onWholeGraph(whole, graph, std::move(*fit), options), effect.constraints,
                    control.part(0.8, 1.0));
}

} // namespace ductus
