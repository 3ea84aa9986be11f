// Shortest paths in the dual graph of a mesh: triangles are nodes, shared edges are arcs weighted by the
// distance between centroids (thesis Sec. III.5.1: enough to know which edges a stroke segment crosses).
#pragma once

#include "geometry/mesh_topology.h"

namespace ductus {

class DualPaths
{
public:
    /// Both must outlive the object. One object serves one thread (it reuses its work arrays).
    DualPaths(const TriangleMesh &mesh, const MeshTopology &topology);

    /// Edges crossed on the way from triangle \a from to \a to, in order; empty if they are the same, or if
    /// no path shorter than \a maxLength exists (then \a found, if given, is false).
    /// Only edges with exactly two triangles are crossed; length is measured from centroid to centroid.
    std::vector<int> crossedEdges(int from, int to, double maxLength, bool *found = nullptr);

private:
    const TriangleMesh &mMesh;
    const MeshTopology &mTopology;
    std::vector<Vec3> mCentroids;
    std::vector<double> mDistance;
    std::vector<int> mViaEdge;
    std::vector<int> mTouched;
};

} // namespace ductus
