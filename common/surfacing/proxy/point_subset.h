// A well-spread subset of points: farthest-point sampling, deterministic.
#pragma once

#include "geometry/triangle_mesh.h"

namespace ductus {

/// At most \a count indices into \a points, each next one as far as possible from those before; stops early when
/// the next would be nearer than \a minDistance. Starts from the point furthest from the centroid.
std::vector<int> farthestPoints(const std::vector<Vec3> &points, int count, double minDistance);

} // namespace ductus
