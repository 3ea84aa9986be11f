// The point of one triangle nearest to a point.
#pragma once

#include "geometry/triangle_mesh.h"

namespace ductus {

/// Barycentric coordinates of the point of triangle abc nearest to \a p; each >= 0, sum 1. The triangle must
/// have an area. [Ericson 2005, Sec. 5.1.5]
Vec3 nearestBarycentric(const Vec3 &p, const Vec3 &a, const Vec3 &b, const Vec3 &c);

double distanceToTriangle(const Vec3 &p, const Vec3 &a, const Vec3 &b, const Vec3 &c);

} // namespace ductus
