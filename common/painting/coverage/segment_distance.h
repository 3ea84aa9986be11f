// How far a point is from the skin of a segment, and in which direction.
#pragma once

#include "painting/coverage/section.h"

namespace ductus {

struct SegmentDistance
{
    double distance = 0;           // negative inside
    Vec3 direction = Vec3::Zero(); // unit, across the skin (of either sign); zero where there is none
};

/// Exact for round segments (without their planes) and ribbons; ellipses count as the box around them.
SegmentDistance segmentDistance(const SegmentData &segment, const Vec3 &x);

} // namespace ductus
