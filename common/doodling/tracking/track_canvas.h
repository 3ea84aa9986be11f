// Where a canvas is in every frame, from keyframes of its position, depth, orientation and size that are
// independent of each other (doodles.md section 1; thesis VI.4, VI.5.2). Every keyframe is met exactly.
#pragma once

#include "doodling/tracking/orientation.h"
#include "doodling/tracking/track_point.h"

#include <vector>

namespace ductus {

/// How far the canvas is away in a frame: scene units along the camera's axis, > 0. Where it is in the
/// picture does not change with it.
struct DepthKeyframe
{
    int frame = 0;
    double depth = 1.0;
};

/// How the canvas is turned in a frame.
struct TurnKeyframe
{
    int frame = 0;
    Eigen::Quaterniond worldFromCanvas = Eigen::Quaterniond::Identity();
    bool interpolatesNext = false; // to the next keyframe by the shortest turn, whatever the scene does
};

/// The canvas' size in a frame as a multiple of its own, > 0.
struct ScaleKeyframe
{
    int frame = 0;
    double scale = 1.0;
};

/// Each list by frame, each frame once. Only positions may not be empty.
struct CanvasKeyframes
{
    std::vector<CanvasKeyframe> positions; // working pixels; a depth in it counts as a DepthKeyframe there
    std::vector<DepthKeyframe> depths;     // none: the scene's depth
    std::vector<TurnKeyframe> turns;       // none: faces the camera in the first position's frame
    std::vector<ScaleKeyframe> scales;     // none: 1
};

/// What the canvas does between keyframes besides following its point.
enum class CanvasTurning {
    AlongPath, // keeps its direction relative to where it goes (thesis Eq. VI.3)
    Still,     // turns from keyframe to keyframe only, by the shortest way
    WithThing  // turns as the thing around its point does in the picture: the dancer of thesis Fig. VI.9
};

struct CanvasTrackOptions
{
    TrackOptions track;
    OrientationOptions orientation;
    CanvasTurning turning = CanvasTurning::AlongPath;
    bool followsSize = false; // grows between keyframes of its size as the thing around its point does
};

struct CanvasFrame
{
    Vec3 position = Vec3::Zero(); // of the canvas' middle, world
    Vec2 pixel = Vec2::Zero();    // the same in the picture, working pixels
    double depth = 0.0;           // along the camera's axis
    Eigen::Quaterniond worldFromCanvas = Eigen::Quaterniond::Identity(); // canvas: x right, y down, z away
    double scale = 1.0;
    bool isVisible = true; // the point is inside the picture and not hidden
};

struct CanvasTrack
{
    std::vector<CanvasFrame> frames; // one a frame of the shot
};

/// InvalidArgument for keyframes out of order or beyond the shot, without a place, a depth or a size.
Result<CanvasTrack> trackCanvas(const Shot &shot, const CanvasKeyframes &keyframes,
                                const CanvasTrackOptions &options, const JobControl &control);

} // namespace ductus
