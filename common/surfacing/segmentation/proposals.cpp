#include "surfacing/segmentation/proposals.h"

#include "base/parallel.h"
#include "surfacing/segmentation/data_costs.h"
#include "surfacing/segmentation/region_fit.h"

#include <algorithm>
#include <map>

namespace ductus {

namespace {

struct Proposal
{
    RegionSupport support;
    int degree;
};

std::size_t hashOf(const std::vector<int> &points)
{
    std::size_t hash = points.size();
    for (int i : points)
        hash = hash * 1099511628211ull + std::size_t(i) + 0x9e3779b97f4a7c15ull;
    return hash;
}

// Neighbouring labels with the weight of the border between them, heaviest first.
std::vector<std::pair<int, int>> neighboursByBorderWeight(const Association &association,
                                                          const MeshTopology &topology,
                                                          const std::vector<int> &labels)
{
    std::map<std::pair<int, int>, double> weights;
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const int a = labels[std::size_t(topology.edges[e].v0)],
                  b = labels[std::size_t(topology.edges[e].v1)];
        if (a != b)
            weights[{std::min(a, b), std::max(a, b)}] += association.edgeWeights[e];
    }
    std::vector<std::pair<std::pair<int, int>, double>> sorted(weights.begin(), weights.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto &l, const auto &r) { return l.second > r.second; });
    std::vector<std::pair<int, int>> pairs;
    for (const auto &[pair, weight] : sorted)
        pairs.push_back(pair);
    return pairs;
}

// Connected parts of regions whose models contradict the proxy there, each with the strokes around it: a flat
// bottom seen as the inside of the cylinder through its rim.
std::vector<RegionSupport> contradictedParts(const Association &association, const MeshTopology &topology,
                                             const std::vector<int> &labels,
                                             const std::vector<ImplicitPolynomial> &models,
                                             const ProxyPrior &prior)
{
    constexpr int fewest = 8;    // stroke points, to fit anything to
    constexpr int ringCount = 2; // to reach the strokes around
    std::vector<char> isContradicted(labels.size(), 0);
    for (std::size_t v = 0; v < association.vertices.size(); ++v)
        isContradicted[v] =
            association.pointsOfVertex[v].empty() &&
            contradiction(association.vertices[v], models[std::size_t(labels[v])], prior) > 0.0;
    std::vector<RegionSupport> parts;
    std::vector<char> isDone(labels.size(), 0);
    for (std::size_t seed = 0; seed < labels.size(); ++seed) {
        if (!isContradicted[seed] || isDone[seed])
            continue;
        std::vector<char> flags(labels.size(), 0);
        std::vector<int> part{int(seed)};
        isDone[seed] = flags[seed] = 1;
        const auto grow = [&](std::size_t from, std::size_t to, auto accept) {
            for (std::size_t i = from; i < to; ++i)
                for (int e : topology.vertexEdges[std::size_t(part[i])]) {
                    const std::size_t w = std::size_t(topology.neighbour(part[i], e));
                    if (flags[w] || !accept(w))
                        continue;
                    flags[w] = 1;
                    part.push_back(int(w));
                }
        };
        for (std::size_t from = 0, to = 1; from < to; from = to, to = part.size())
            grow(from, to, [&](std::size_t w) { return isContradicted[w] && labels[w] == labels[seed]; });
        for (int v : part)
            isDone[std::size_t(v)] = 1;
        for (int ring = 0; ring < ringCount; ++ring)
            grow(0, part.size(), [](std::size_t) { return true; });
        RegionSupport support = supportOf(association, flags);
        if (int(support.points.size()) >= fewest)
            parts.push_back(std::move(support));
    }
    return parts;
}

} // namespace

std::vector<ImplicitPolynomial> proposeModels(const Association &association, const MeshTopology &topology,
                                              const std::vector<int> &labels,
                                              const std::vector<ImplicitPolynomial> &models,
                                              const SegmentationOptions &options, TriedMerges &tried)
{
    std::vector<Proposal> proposals;
    std::vector<RegionSupport> supportOfLabel(models.size());
    for (std::size_t a = 0; a < models.size(); ++a) {
        std::vector<char> flags(labels.size());
        for (std::size_t v = 0; v < labels.size(); ++v)
            flags[v] = labels[v] == int(a);
        supportOfLabel[a] = supportOf(association, flags);
        for (int degree = models[a].degree - 1; degree >= 1 && !supportOfLabel[a].points.empty(); --degree)
            proposals.push_back({supportOfLabel[a], degree});
    }

    int merges = 0;
    for (const auto &[a, b] : neighboursByBorderWeight(association, topology, labels)) {
        if (merges == options.mergesPerIteration)
            break;
        const RegionSupport &sa = supportOfLabel[std::size_t(a)], &sb = supportOfLabel[std::size_t(b)];
        if (sa.points.empty() && sb.points.empty())
            continue;
        const std::pair<std::size_t, std::size_t> key = std::minmax(hashOf(sa.points), hashOf(sb.points));
        if (!tried.insert(key).second)
            continue;
        const RegionSupport support = united(sa, sb);
        // Two planes or two quadrics can be one surface of the next degree, two bits of a face one plane.
        const int highest = std::min(
            options.maxDegree, std::max(models[std::size_t(a)].degree, models[std::size_t(b)].degree) + 1);
        for (int degree = 1; degree <= highest; ++degree)
            proposals.push_back({support, degree});
        ++merges;
    }

    for (const RegionSupport &part :
         contradictedParts(association, topology, labels, models, options.proxyPrior))
        for (int degree = 1; degree <= std::min(2, options.maxDegree); ++degree)
            proposals.push_back({part, degree});

    std::vector<ImplicitPolynomial> result(proposals.size());
    parallelFor(0, proposals.size(), [&](std::size_t i) {
        result[i] = fitRegion(association, proposals[i].support, proposals[i].degree, options.fit);
    });
    return result;
}

} // namespace ductus
