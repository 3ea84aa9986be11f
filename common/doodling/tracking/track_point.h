// From keyframes to a trajectory (thesis VI.5.2): a rough path through similar cells, then positions that
// follow the scene flow sampled along it and pass through the keyframes.
//
// Beyond the thesis: flow is first followed from the keyframes, from one frame to the next, and only where it
// is not to be trusted along the rough path: where it is, it is exact to parts of a pixel, and the path to
// half a cell. Each step is looked at from both of its ends.
#pragma once

#include "doodling/reconstruction/shot.h"
#include "doodling/tracking/layered_path.h"
#include "doodling/tracking/trajectory.h"

#include <optional>

namespace ductus {

/// Where the user put a canvas: working pixels.
struct CanvasKeyframe
{
    int frame = 0;
    Vec2 pixel = Vec2::Zero();
    std::optional<double> depth; // set by the depth slider; else the scene's
    bool interpolatesNext = false;
};

struct TrackedPoint
{
    Vec3 position = Vec3::Zero(); // world
    Vec2 pixel = Vec2::Zero();
    double depth = 0.0;
    bool isVisible = true; // inside the picture and not hidden
};

struct TrackOptions
{
    double keptShare = 0.1;     // of the cells of a frame, thesis VI.5.2
    double unsafeJump = 0.7;    // cells: one whose flow is not trusted costs like a jump so far
    double hiddenJump = 0.9;    // cells: the same for a frame in hiding; steps between middles jump up to 0.7
    double followedFrom = 0.25; // confidence: where it is less, the rough path's motion is followed
    int samplings = 2;          // of the flow along the trajectory
    int hiddenPoints = 48;      // see LayeredPathOptions
    int longestHidden = 24;     // frames
    TrajectoryOptions trajectory;
};

/// One point a frame. \a keyframes by frame, each frame once, at least one.
Result<std::vector<TrackedPoint>> trackPoint(const Shot &shot, const std::vector<CanvasKeyframe> &keyframes,
                                             const TrackOptions &options, const JobControl &control);

} // namespace ductus
