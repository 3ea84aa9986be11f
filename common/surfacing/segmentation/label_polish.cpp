#include "surfacing/segmentation/label_polish.h"

#include "base/parallel.h"

namespace ductus {

namespace {

constexpr int ringsAroundBorders = 6;
constexpr double fixed = 1e3; // against other labels further away: more than any energy there is

std::vector<char> nearBorders(const MeshTopology &topology, const std::vector<int> &labels)
{
    std::vector<char> isNear(labels.size(), 0);
    std::vector<int> front;
    const auto reach = [&](int v) {
        if (!isNear[std::size_t(v)]) {
            isNear[std::size_t(v)] = 1;
            front.push_back(v);
        }
    };
    for (const MeshEdge &edge : topology.edges)
        if (labels[std::size_t(edge.v0)] != labels[std::size_t(edge.v1)]) {
            reach(edge.v0);
            reach(edge.v1);
        }
    for (int ring = 0; ring < ringsAroundBorders; ++ring) {
        const std::vector<int> last = std::move(front);
        front.clear();
        for (int v : last)
            for (int e : topology.vertexEdges[std::size_t(v)])
                reach(topology.neighbour(v, e));
    }
    return isNear;
}

} // namespace

ModelLabeling onWholeGraph(const LabelGraph &whole, const SimplifiedGraph &graph, ModelLabeling fit,
                           const SegmentationOptions &options)
{
    fit.labels = graph.ofVertices(fit.labels);
    parallelFor(0, fit.models.size(), [&](std::size_t a) {
        fit.models[a] =
            labelModel(whole.association, std::move(fit.models[a].model), fit.models[a].id, options);
    });
    return fit;
}

Result<ModelLabeling> polished(const LabelGraph &whole, const SegmentationOptions &options, ModelLabeling fit,
                               const LabelConstraints &constraints, const JobControl &control)
{
    LabelConstraints local = constraints;
    const std::vector<char> isNear = nearBorders(whole.topology, fit.labels);
    for (std::size_t v = 0; v < isNear.size(); ++v)
        if (!isNear[v])
            local.preferences.push_back({int(v), fit.models[std::size_t(fit.labels[v])].id, true, fixed});
    return fitModels(whole, options, std::move(fit), local, Proposals::Nothing, control);
}

} // namespace ductus
