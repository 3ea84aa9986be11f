// A stable trajectory from scene flow sampled along a rough one, through keyframed pixels (thesis VI.5.2, Eq.
// VI.2):
//
//     min_P  sum_t w_t |P^{t+1} - P^t - V^t|^2  +  lambda sum_k |P~^k - P^k|^2      P^k on the ray of
//     keyframe k
//
// Between two keyframes the best positions are known in closed form: the flow's sums plus a share of what is
// missing, a share in proportion to 1 / w_t. So the unknowns are one ray depth a keyframe, coupled with the
// neighbours only: a tridiagonal system that takes microseconds, where the thesis solves for all positions
// with Lagrange multipliers.
//
// Beyond the thesis: the weights w_t. Where flow is not to be trusted (the object is hidden) the correction
// is made there, unseen; the thesis spreads it evenly.
#pragma once

#include "base/result.h"
#include "geometry/triangle_mesh.h"

#include <optional>
#include <vector>

namespace ductus {

/// A canvas' position in one frame. The point at \a depth is where the depth map has the pixel.
struct PositionKeyframe
{
    int frame = 0;
    Vec3 eye = Vec3::Zero();       // of the frame's camera
    Vec3 ray = Vec3::UnitZ();      // of the pixel, see ShotCamera::rayOf
    double depth = 1.0;            // > 0
    bool isDepthFixed = false;     // set by the user: the trajectory passes through that point
    bool interpolatesNext = false; // from here to the next keyframe in a straight line, without tracking
};

struct TrajectoryOptions
{
    double depthWeight = 0.01;  // lambda_depth, thesis VI.5.2
    double nearestDepth = 1e-3; // a solved depth is never less; scene units
};

struct FlowStep
{
    Vec3 motion = Vec3::Zero(); // V^t, from frame t to t + 1
    double confidence = 1.0;    // w_t, > 0
};

/// One position a frame, steps.size() + 1 of them. \a keyframes by frame, each frame once, at least one;
/// before the first and after the last one the flow is followed. InvalidArgument for others.
Result<std::vector<Vec3>> solveTrajectory(const std::vector<FlowStep> &steps,
                                          const std::vector<PositionKeyframe> &keyframes,
                                          const TrajectoryOptions &options = {});

} // namespace ductus
