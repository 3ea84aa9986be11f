// What is known of a filmed scene: cameras, depth, motion and looks of every frame (thesis VI.5.1). Made once
// a clip by reconstructShot; the stages above and all drawing read from it.
//
// All pixels are those of the working copy (at most 480 lines), not of the clip.
#pragma once

#include "doodling/clip/clip.h"
#include "doodling/reconstruction/depth_map.h"
#include "doodling/reconstruction/feature_grid.h"
#include "doodling/reconstruction/flow_field.h"
#include "doodling/reconstruction/long_flow.h"
#include "doodling/reconstruction/small_picture.h"
#include "doodling/scene/shot_camera.h"

namespace ductus {

/// How much of the camera's movement is known: the rungs of the ladder that never refuses a clip, best last.
/// Tripod: the camera stands still. RotationOnly: it turns on the spot, so the scene shows no depth by
/// itself. SolvedCameras: it moves, and depth was measured. On the first two rungs depth is a guess made from
/// what moves and where it touches the ground.
enum class CameraKnowledge { Tripod, RotationOnly, SolvedCameras };

struct Shot
{
    int width = 0, height = 0;         // of the working copy
    int clipWidth = 0, clipHeight = 0; // pixels of the clip
    CameraKnowledge knowledge = CameraKnowledge::Tripod;
    std::vector<ShotCamera> cameras;    // one a frame
    double sceneDepth = 10.0;           // where nothing is known; scene units
    std::vector<DepthMap> depths;       // one a frame, or none: all is at sceneDepth
    std::vector<FlowField> forward;     // from frame t to t + 1
    std::vector<FlowField> backward;    // from frame t + 1 to t
    std::vector<FeatureGrid> features;  // one a frame
    LongFlows longFlows;                // between frames further apart; may be none
    std::vector<SmallPicture> pictures; // one a frame, or none

    int frameCount() const { return int(cameras.size()); }
    /// Along z of the frame's camera, scene units; always positive and finite.
    double depthAt(int frame, const Vec2 &pixel) const;
    /// The number of the object there that moves by itself; 0 for what stands still and where nobody knows.
    int objectAt(int frame, const Vec2 &pixel) const;
    /// Working pixels a pixel of the clip is wide.
    double scale() const { return clipWidth > 0 ? double(width) / clipWidth : 1.0; }
};

struct ShotOptions
{
    int mostLines = 480; // of the working copy
    FlowOptions flow;
};

/// Reads the clip once from front to back. Two frames are held at a time, besides the result.
Result<Shot> reconstructShot(Clip &clip, const ShotOptions &options, const JobControl &control);

} // namespace ductus
