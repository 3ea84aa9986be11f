// The convex hull of points in space.
#pragma once

#include "geometry/triangle_mesh.h"

namespace ductus {

/// Closed and oriented outwards; its triangles name corners by their place in \a points. Empty where the
/// points lie in one plane (or on one line).
std::vector<Triangle> convexHull(const std::vector<Vec3> &points);

} // namespace ductus
