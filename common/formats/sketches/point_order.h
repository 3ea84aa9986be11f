// Telling a drawn polyline from a bag of points.
#pragma once

#include "geometry/triangle_mesh.h"

namespace ductus {

/// True if consecutive \a points are not neighbours: the median distance from a point to the next exceeds
/// three times the median distance to the nearest point. Drawn strokes have ratios from 1 to about 1.5,
/// shuffled samples of a surface or of curves 9 to 85 (measured on VIPSS inputs of 500 to 1000 points). Looks
/// at no more than 32 windows of 512 consecutive points, so the time does not grow with the file. Fewer than
/// 16 points: false.
bool isUnordered(const std::vector<Vec3> &points);

} // namespace ductus
