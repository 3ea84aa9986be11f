#include "surfacing/ambiguity/alternatives.h"

#include "surfacing/ambiguity/ambiguity_map.h"

#include <algorithm>

namespace ductus {

namespace {

// Of borders without one of the other labels nearby.
double lengthAlone(const TriangleMesh &proxy, const MeshTopology &topology, const std::vector<int> &labels,
                   const std::vector<char> &isNearOther)
{
    double length = 0.0;
    for (const MeshEdge &edge : topology.edges) {
        const std::size_t v0 = std::size_t(edge.v0), v1 = std::size_t(edge.v1);
        if (labels[v0] != labels[v1] && !isNearOther[v0] && !isNearOther[v1])
            length += (proxy.vertices[v0] - proxy.vertices[v1]).norm();
    }
    return 0.5 * length; // on even triangles a line crosses two edges on the length of one
}

} // namespace

double borderDifference(const TriangleMesh &proxy, const MeshTopology &topology, const std::vector<int> &a,
                        const std::vector<int> &b, double tolerance)
{
    return lengthAlone(proxy, topology, a, nearBorder(proxy, topology, b, tolerance)) +
           lengthAlone(proxy, topology, b, nearBorder(proxy, topology, a, tolerance));
}

std::vector<int> alternatives(const TriangleMesh &proxy, const MeshTopology &topology,
                              const Segmentation &reference, const std::vector<LabelSample> &samples,
                              const AlternativeOptions &options)
{
    // Of each sample to the nearest of those chosen, the reference among them.
    std::vector<double> difference(samples.size(), -1.0);
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (samples[i].segmentation.energy <= options.worstEnergy * reference.energy)
            difference[i] = borderDifference(proxy, topology, reference.labels,
                                             samples[i].segmentation.labels, options.borderTolerance);
    std::vector<int> chosen;
    while (int(chosen.size()) < options.count) {
        const auto most = std::max_element(difference.begin(), difference.end());
        if (most == difference.end() || *most < options.leastDifference)
            break;
        const std::size_t index = std::size_t(most - difference.begin());
        chosen.push_back(int(index));
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (difference[i] >= 0.0)
                difference[i] = std::min(
                    difference[i], borderDifference(proxy, topology, samples[index].segmentation.labels,
                                                    samples[i].segmentation.labels, options.borderTolerance));
    }
    return chosen;
}

} // namespace ductus
