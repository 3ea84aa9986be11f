// Strokes that lie in one plane of a sketch's convex hull: the sketch could stand on them, as a car on its
// sills. The hull stretches triangles from one side of such an outline to the other, so that the plane is
// found though no stroke shows it alone.
#pragma once

#include "geometry/triangle_mesh.h"

namespace ductus {

struct HullOutline
{
    std::vector<Vec3> points;
    Vec3 outwards = Vec3::UnitZ();
};

/// \a drawn: samples of one stroke each, in the unit frame; strokes with nearly all samples within \a
/// tolerance of a plane lie in it. Planes of greater triangles of the hull first, down to \a leastArea.
std::vector<HullOutline> outlinesOnHull(const std::vector<std::vector<Vec3>> &drawn, double tolerance,
                                        double leastArea);

/// Nearly all of \a stroke is within \a tolerance of the plane.
bool liesInPlane(const std::vector<Vec3> &stroke, const Vec3 &centre, const Vec3 &normal, double tolerance);

} // namespace ductus
