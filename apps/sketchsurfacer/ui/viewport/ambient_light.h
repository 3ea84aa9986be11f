// How much of the sky each vertex of a mesh sees: ambient occlusion computed once, so that a turning view
// costs nothing more (screen-space occlusion would cost every frame, and much on machines without a graphics
// card).
#pragma once

#include "base/job_control.h"
#include "geometry/inspection/ray_tree.h"

namespace ductus {

/// One value a vertex: \a darkest where all rays meet the mesh within \a reach, 1 where none does. Both sides
/// of an open surface are treated as its outside only. Returns an empty vector when cancelled.
std::vector<float> ambientLight(const TriangleMesh &mesh, const RayTree &tree, double reach, float darkest,
                                const JobControl &control);

} // namespace ductus
