// From keyframes to a trajectory (thesis VI.5.2): where the point is in the picture of every frame
// (pixel_path.h), how far away it is there, and positions in the scene that pass through the keyframes
// (trajectory.h).
//
// Beyond the thesis: its rough path is a sampling of the scene flow's places, ours is exact in the picture;
// so the picture is what is kept, and only depth is smoothed and solved for.
#pragma once

#include "doodling/reconstruction/shot.h"
#include "doodling/tracking/depth_along.h"
#include "doodling/tracking/pixel_path.h"
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
    // How the thing around the point turned in the picture (radians, clockwise as seen) and grew (a factor)
    // since the first keyframe.
    double turn = 0.0, growth = 1.0;
};

struct TrackOptions
{
    PixelPathOptions path;
    DepthSmoothing depth;
    double hiddenWeight = 1e-3; // of depths and steps of frames in which the point is hidden
    TrajectoryOptions trajectory;
};

/// One point a frame. \a keyframes by frame, each frame once, at least one.
Result<std::vector<TrackedPoint>> trackPoint(const Shot &shot, const std::vector<CanvasKeyframe> &keyframes,
                                             const TrackOptions &options, const JobControl &control);

} // namespace ductus
