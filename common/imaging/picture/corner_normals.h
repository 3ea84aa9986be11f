// Normals that are smooth across gentle edges and break at sharp ones, and the edges where they break.
#pragma once

#include "geometry/triangle_mesh.h"

#include <functional>
#include <utility>

namespace ductus::picture {

struct CornerNormals
{
    std::vector<Vec3> faces;                  // unit, zero for triangles without area
    std::vector<std::array<Vec3, 3>> corners; // unit, one a corner of each triangle
};

/// At each corner the mean, weighted by the angle there, of the faces around the vertex whose normals are
/// within \a creaseAngleDegrees of this face's; 0 gives flat faces. Indices must be valid.
CornerNormals cornerNormals(const TriangleMesh &mesh, double creaseAngleDegrees);

/// Vertex pairs of the edges worth a line: sharper than \a creaseAngleDegrees, on the border, shared by more
/// than two triangles, or between triangles t, u for which \a differ(t, u) holds.
std::vector<std::pair<int, int>> creaseEdges(const TriangleMesh &mesh, double creaseAngleDegrees,
                                             const std::function<bool(int, int)> &differ);

} // namespace ductus::picture
