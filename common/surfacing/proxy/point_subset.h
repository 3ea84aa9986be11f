// Well-spread subsets of points, deterministic.
#pragma once

#include "geometry/triangle_mesh.h"

namespace ductus {

/// At most \a count indices into \a points, each next one as far as possible from those before; stops early when
/// the next would be nearer than \a minDistance. Starts from the point furthest from the centroid.
std::vector<int> farthestPoints(const std::vector<Vec3> &points, int count, double minDistance);

/// Each point that is farther than \a minDistance from those kept before it, in order: the spread of farthestPoints
/// for many points, in time about linear in their number.
std::vector<Vec3> spreadOut(const std::vector<Vec3> &points, double minDistance);

/// Median distance of a point to its nearest other; 0 for fewer than two.
double medianSpacing(const std::vector<Vec3> &points);

} // namespace ductus
