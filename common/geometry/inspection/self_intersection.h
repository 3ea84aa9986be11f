// Where a mesh runs through itself.
#pragma once

#include "geometry/triangle_mesh.h"

#include <utility>
#include <vector>

namespace ductus {

using TrianglePair = std::pair<int, int>; // first < second

/// Pairs of triangles that meet elsewhere than in the corners and edges they share, in ascending order: all,
/// or the \a most found first. Exact. Indices must be valid; triangles with a repeated corner count as
/// meeting whatever they touch.
std::vector<TrianglePair> selfIntersections(const TriangleMesh &mesh, int most = 10'000);

} // namespace ductus
