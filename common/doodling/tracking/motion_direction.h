// Where a trajectory goes, and where it turns too abruptly to tell (thesis VI.5.2, tracking of orientations).
#pragma once

#include "doodling/tracking/orientation.h"

namespace ductus {

struct MotionDirection
{
    std::vector<Vec3> directions; // v^t, unit; zero in frames without one
    std::vector<double> weights;  // w_t, 0..1; 0 in frames without a direction
    std::vector<int> segments;    // s(t), -1 in frames without a direction
    int segmentCount = 0;
};

MotionDirection motionDirections(const std::vector<Vec3> &trajectory, const OrientationOptions &options);

} // namespace ductus
