// Closing holes of a manifold mesh (CGAL's minimal triangulation of border loops behind a narrow interface).
#pragma once

#include "base/result.h"
#include "geometry/triangle_mesh.h"

namespace ductus {

/// Border loops as vertex indices, each running along its border edges; longest perimeter first.
std::vector<std::vector<int>> borderLoops(const TriangleMesh &mesh);

double loopLength(const TriangleMesh &mesh, const std::vector<int> &loop);

/// \a mesh with every border loop shorter than \a maxLength closed by flat-as-possible triangles between its own
/// vertices (remesh afterwards). Loops CGAL cannot close stay open.
TriangleMesh withHolesFilled(const TriangleMesh &mesh, double maxLength);

} // namespace ductus
