#include "surfacing/extraction/feature_lines.h"

#include <map>

namespace ductus {

std::vector<std::vector<int>> featureLines(const SeamedMesh &seamed, const std::vector<double> &sharpness)
{
    constexpr double sharp = 0.5; // half way between smoothed over and crease
    std::map<int, std::vector<std::size_t>> edgesOfVertex;
    std::vector<std::pair<int, int>> edges;
    for (const auto &[a, b] : seamed.seamEdges)
        if (sharpness[std::size_t(a)] >= sharp && sharpness[std::size_t(b)] >= sharp) {
            edgesOfVertex[a].push_back(edges.size());
            edgesOfVertex[b].push_back(edges.size());
            edges.emplace_back(a, b);
        }
    std::vector<char> used(edges.size(), 0);
    std::vector<std::vector<int>> lines;
    const auto walk = [&](int from, std::size_t edge) {
        std::vector<int> line{from};
        int v = from;
        while (true) {
            used[edge] = 1;
            v = edges[edge].first == v ? edges[edge].second : edges[edge].first;
            line.push_back(v);
            const std::vector<std::size_t> &around = edgesOfVertex[v];
            if (around.size() != 2)
                break;
            edge = around[used[around[0]] ? 1 : 0];
            if (used[edge])
                break;
        }
        lines.push_back(std::move(line));
    };
    for (const auto &[v, around] : edgesOfVertex) // ends and junctions first, closed loops after
        if (around.size() != 2)
            for (std::size_t edge : around)
                if (!used[edge])
                    walk(v, edge);
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (!used[e])
            walk(edges[e].first, e);
    return lines;
}

} // namespace ductus
