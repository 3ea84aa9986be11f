#include "surfacing/extraction/border_strokes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <queue>

namespace ductus {

namespace {

// To the nearest flagged vertex that is reached along edges, straight, since ways along edges are longer than
// ways over the surface; \a most where none is so near.
std::vector<double> distancesFrom(const std::vector<char> &flags, const TriangleMesh &mesh,
                                  const MeshTopology &topology, double most)
{
    std::vector<std::vector<int>> neighbours(flags.size());
    for (const MeshEdge &edge : topology.edges) {
        neighbours[std::size_t(edge.v0)].push_back(edge.v1);
        neighbours[std::size_t(edge.v1)].push_back(edge.v0);
    }
    struct Reached
    {
        double distance;
        int vertex, source;
        bool operator<(const Reached &other) const { return distance > other.distance; }
    };
    std::priority_queue<Reached> front;
    std::vector<double> distances(flags.size(), most);
    for (std::size_t v = 0; v < flags.size(); ++v)
        if (flags[v])
            front.push({distances[v] = 0.0, int(v), int(v)});
    while (!front.empty()) {
        const Reached reached = front.top();
        front.pop();
        if (reached.distance > distances[std::size_t(reached.vertex)])
            continue;
        for (const int next : neighbours[std::size_t(reached.vertex)]) {
            const double distance =
                (mesh.vertices[std::size_t(next)] - mesh.vertices[std::size_t(reached.source)]).norm();
            if (distance < distances[std::size_t(next)])
                front.push({distances[std::size_t(next)] = distance, next, reached.source});
        }
    }
    return distances;
}

double extentOf(const Stroke &stroke)
{
    Eigen::AlignedBox3d box;
    for (const Vec3 &p : stroke.points)
        box.extend(p);
    return stroke.points.empty() ? 0.0 : box.diagonal().norm();
}

bool runsAlong(std::vector<double> distances, double extent, const BorderStrokeOptions &options)
{
    if (distances.empty() || extent < options.leastExtent)
        return false;
    std::sort(distances.begin(), distances.end());
    const auto near = std::upper_bound(distances.begin(), distances.end(), options.reach) - distances.begin();
    // The greater part of it counts, since strokes are drawn too far.
    const std::size_t few = distances.size() / 5;
    const double approach = distances[distances.size() - 1 - few] - distances[few];
    return double(near) >= options.leastShare * double(distances.size()) &&
           approach <= options.mostApproach * extent;
}

} // namespace

std::vector<char> strokesAlongBorder(const TriangleMesh &proxy, const MeshTopology &topology,
                                     const Association &association, const StrokeSet &strokes,
                                     const std::vector<char> &isBeyond, const BorderStrokeOptions &options)
{
    const std::vector<double> distances = distancesFrom(isBeyond, proxy, topology, 3.0 * options.reach);
    std::vector<std::vector<double>> distancesOfStroke(strokes.strokes.size());
    for (const StrokeSample &sample : association.samples) {
        const MeshEdge &edge = topology.edges[std::size_t(sample.edge)];
        distancesOfStroke[std::size_t(sample.stroke)].push_back(
            0.5 * (distances[std::size_t(edge.v0)] + distances[std::size_t(edge.v1)]));
    }
    std::vector<char> isAlong(strokes.strokes.size(), 0);
    for (std::size_t s = 0; s < isAlong.size(); ++s)
        isAlong[s] = runsAlong(std::move(distancesOfStroke[s]), extentOf(strokes.strokes[s]), options);
    return isAlong;
}

std::vector<char> grownByRings(std::vector<char> flags, const MeshTopology &topology, int rings)
{
    for (int ring = 0; ring < rings; ++ring) {
        std::vector<char> next = flags;
        for (const MeshEdge &e : topology.edges)
            if (flags[std::size_t(e.v0)] || flags[std::size_t(e.v1)])
                next[std::size_t(e.v0)] = next[std::size_t(e.v1)] = 1;
        flags = std::move(next);
    }
    return flags;
}

} // namespace ductus
