// The graph that is labelled, made smaller away from strokes (thesis Sec. III.6, Graph simplification):
// vertices without stroke points only smooth, so neighbours among them are joined, low valences first and
// none above 12.
//
// The thesis collapses edges of the mesh and rescales edge weights by the triangles' size. Here joined
// vertices form clusters and the weights of all edges between two clusters are added up: the energy of a
// labelling of the clusters is exactly the energy of the same labels on the whole graph,
// but for what the proxy objects to (data_costs.h): there one vertex speaks for its cluster, with the weight of all.
#pragma once

#include "surfacing/segmentation/multi_model_fit.h"

#include <span>

namespace ductus {

struct GraphSimplificationOptions
{
    int maxValence = 12; // Sec. III.6
};

struct SimplifiedGraph
{
    Association association; // of the clusters: all points, summed weights
    MeshTopology topology;   // only edges and vertexEdges: clusters have no faces
    std::vector<int> clusterOfVertex;

    /// Labels of clusters carried back to the vertices.
    std::vector<int> ofVertices(const std::vector<int> &ofClusters) const;
};

/// Vertices with stroke points and those flagged in \a kept (may be empty) stay alone; vertices of different
/// \a labels (may be empty) are never joined.
SimplifiedGraph simplified(const Association &association, const MeshTopology &topology,
                           std::span<const char> kept, std::span<const int> labels,
                           const GraphSimplificationOptions &options);

} // namespace ductus
