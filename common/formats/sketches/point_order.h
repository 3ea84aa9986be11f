// Telling a drawn polyline from a bag of points.
#pragma once

#include "geometry/triangle_mesh.h"

#include <vector>

namespace ductus {

/// True if consecutive \a points are not neighbours: the median distance from a point to the next exceeds
/// three times the median distance to the nearest other point, and a tenth of the box diagonal (dense
/// hatching has near neighbours across its rows, but small steps). Ratios measured: drawn strokes 1 to
/// about 1.5, the shuffled VIPSS inputs of 500 to 1000 points 9 to 85. Looks at no more than 32 windows of
/// 512 consecutive points, so the time does not grow with the file. Fewer than 16 points: false.
bool isUnordered(const std::vector<Vec3> &points);

} // namespace ductus
