#include "surfacing/extraction/border_strokes.h"

#include <Eigen/Geometry>

namespace ductus {

std::vector<char> strokesAlongBorder(const MeshTopology &topology, const Association &association,
                                     const StrokeSet &strokes, const std::vector<char> &isBeyond,
                                     const BorderStrokeOptions &options)
{
    const std::vector<char> isNear = grownByRings(isBeyond, topology, options.reachRings);
    std::vector<int> near(strokes.strokes.size(), 0), all(strokes.strokes.size(), 0);
    for (const StrokeSample &sample : association.samples) {
        const MeshEdge &edge = topology.edges[std::size_t(sample.edge)];
        near[std::size_t(sample.stroke)] += isNear[std::size_t(edge.v0)] && isNear[std::size_t(edge.v1)];
        ++all[std::size_t(sample.stroke)];
    }
    std::vector<char> isAlong(strokes.strokes.size(), 0);
    for (std::size_t s = 0; s < isAlong.size(); ++s) {
        Eigen::AlignedBox3d box;
        for (const Vec3 &p : strokes.strokes[s].points)
            box.extend(p);
        isAlong[s] = all[s] > 0 && near[s] >= options.leastShare * all[s] &&
                     box.diagonal().norm() >= options.leastExtent;
    }
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
