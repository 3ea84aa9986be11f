// Connectivity of a TriangleMesh: its edges, who is next to whom, where it ends and where it is not a
// surface.
#pragma once

#include "geometry/triangle_mesh.h"

#include <vector>

namespace ductus {

struct MeshEdge
{
    int v0 = -1; // v0 < v1
    int v1 = -1;
    int faces[2] = {-1, -1}; // the first two triangles found; -1 where there is none
    int faceCount = 0;       // 1 on the border, 2 inside, more where the mesh is not a manifold
};

struct MeshTopology
{
    std::vector<MeshEdge> edges;               // sorted by (v0, v1)
    std::vector<std::array<int, 3>> faceEdges; // edge k of a face joins its corners k and k+1
    std::vector<std::vector<int>> vertexEdges; // ascending
    std::vector<std::vector<int>> vertexFaces; // ascending

    /// Indices must be valid. A triangle with a repeated corner takes no part: its faceEdges are -1.
    explicit MeshTopology(const TriangleMesh &mesh);

    /// -1 if the two vertices share no edge.
    int edgeBetween(int a, int b) const;
    int neighbour(int vertex, int edge) const
    {
        return edges[edge].v0 == vertex ? edges[edge].v1 : edges[edge].v0;
    }
    /// The triangle across \a edge from \a face, or -1. Means nothing where the edge has more than two
    /// triangles.
    int across(int edge, int face) const
    {
        return edges[edge].faces[0] == face ? edges[edge].faces[1] : edges[edge].faces[0];
    }
    bool isBorder(int edge) const { return edges[edge].faceCount == 1; }
    std::vector<char> borderVertices() const; // 1 where a border edge ends
};

struct ManifoldReport
{
    int borderEdges = 0;
    int nonManifoldEdges = 0;    // more than two triangles
    int inconsistentEdges = 0;   // both triangles run it in the same direction
    int nonManifoldVertices = 0; // the triangles around do not form one fan
    int degenerateTriangles = 0; // repeated corner, or no area
    int components = 0;

    bool isManifold() const
    {
        return nonManifoldEdges == 0 && nonManifoldVertices == 0 && inconsistentEdges == 0;
    }
    bool isClosed() const { return isManifold() && borderEdges == 0; }
};

ManifoldReport manifoldReport(const TriangleMesh &mesh);

/// Connected component (by shared edges) of each triangle, numbered from 0 in order of first triangle.
std::vector<int> triangleComponents(const MeshTopology &topology, int *count = nullptr);

} // namespace ductus
