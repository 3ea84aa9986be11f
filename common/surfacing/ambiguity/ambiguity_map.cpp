#include "surfacing/ambiguity/ambiguity_map.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace ductus {

namespace {

// A model that runs wild where it has no strokes is no worse than one this far away.
constexpr double farthestSurface = 0.05;

std::vector<double> surfaceHeights(const TriangleMesh &proxy, const Segmentation &segmentation)
{
    std::vector<double> heights(proxy.vertices.size());
    for (std::size_t v = 0; v < heights.size(); ++v) {
        const ImplicitPolynomial &model = segmentation.models[std::size_t(segmentation.labels[v])];
        heights[v] = std::clamp(-model.signedDistance(proxy.vertices[v]), -farthestSurface, farthestSurface);
    }
    return heights;
}

} // namespace

std::vector<char> nearBorder(const TriangleMesh &proxy, const MeshTopology &topology,
                             const std::vector<int> &labels, double distance)
{
    std::vector<double> walked(labels.size(), 2.0 * distance + 1.0);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    const auto reach = [&](int v, double at) {
        if (at <= distance && at < walked[std::size_t(v)]) {
            walked[std::size_t(v)] = at;
            front.push({at, v});
        }
    };
    const auto length = [&](const MeshEdge &edge) {
        return (proxy.vertices[std::size_t(edge.v0)] - proxy.vertices[std::size_t(edge.v1)]).norm();
    };
    for (const MeshEdge &edge : topology.edges)
        if (labels[std::size_t(edge.v0)] != labels[std::size_t(edge.v1)])
            for (int v : {edge.v0, edge.v1})
                reach(v, 0.0);
    while (!front.empty()) {
        const auto [at, v] = front.top();
        front.pop();
        if (at > walked[std::size_t(v)])
            continue;
        for (int e : topology.vertexEdges[std::size_t(v)])
            reach(topology.neighbour(v, e), at + length(topology.edges[std::size_t(e)]));
    }
    std::vector<char> flags(labels.size());
    for (std::size_t v = 0; v < flags.size(); ++v)
        flags[v] = walked[v] <= distance;
    return flags;
}

AmbiguityMap ambiguityOf(const TriangleMesh &proxy, const MeshTopology &topology,
                         const std::vector<LabelSample> &samples, const AmbiguityMapOptions &options)
{
    std::vector<std::vector<char>> borders(samples.size());
    std::vector<std::vector<double>> heights(samples.size());
    parallelFor(0, samples.size(), [&](std::size_t i) {
        borders[i] = nearBorder(proxy, topology, samples[i].segmentation.labels, options.borderTolerance);
        heights[i] = surfaceHeights(proxy, samples[i].segmentation);
    });
    double total = 0.0;
    for (const LabelSample &sample : samples)
        total += sample.weight;
    const std::size_t count = proxy.vertices.size();
    AmbiguityMap map{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
    for (std::size_t v = 0; v < count; ++v) {
        double withBorder = 0.0, mean = 0.0, variance = 0.0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double share = samples[i].weight / total;
            withBorder += share * (borders[i][v] ? 1.0 : 0.0);
            mean += share * heights[i][v];
        }
        for (std::size_t i = 0; i < samples.size(); ++i)
            variance += samples[i].weight / total * (heights[i][v] - mean) * (heights[i][v] - mean);
        map.border[v] = std::max(0.0, 4.0 * withBorder * (1.0 - withBorder));
        map.surface[v] = std::min(1.0, std::sqrt(variance) / options.surfaceScale);
        map.either[v] = std::max(map.border[v], map.surface[v]);
    }
    return map;
}

} // namespace ductus
