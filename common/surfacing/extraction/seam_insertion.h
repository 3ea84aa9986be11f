// Seams: splits the triangles of a labelled mesh so that borders between labels run along edges (thesis
// Sec. III.5.4, Insertion of segmentation boundaries). A triangle with two labels becomes three, one with three
// labels six. The same splitting trims open surfaces, with the labels inside and outside.
#pragma once

#include "geometry/mesh_topology.h"

namespace ductus {

struct SeamedMesh
{
    TriangleMesh mesh;                             // first the old vertices, then the inserted ones
    std::vector<int> triangleLabels;               // one label a triangle
    std::vector<std::vector<int>> vertexLabels;    // one for old vertices, two or three for inserted ones, ascending
    std::vector<std::pair<int, int>> seamEdges;    // edges of the mesh with different labels on their sides
};

/// \a cutPositions: for each edge of \a topology where from v0 (0) to v1 (1) a seam would cross it; clamped to keep
/// triangles fat.
SeamedMesh insertSeams(const TriangleMesh &mesh, const MeshTopology &topology, const std::vector<int> &labels,
                       const std::vector<double> &cutPositions);

} // namespace ductus
