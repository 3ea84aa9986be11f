// What is known of a filmed scene: cameras, depth, motion and looks of every frame (thesis VI.5.1). Made once
// a clip by reconstructShot; the stages above and all drawing read from it.
//
// All pixels are those of the working copy (at most 480 lines), not of the clip.
#pragma once

#include "doodling/clip/clip.h"
#include "doodling/reconstruction/feature_grid.h"
#include "doodling/reconstruction/flow_field.h"
#include "doodling/scene/shot_camera.h"

namespace ductus {

/// How much of the camera's movement is known: the rungs of the ladder that never refuses a clip.
/// Tripod: the scene is taken for a picture at one depth; canvases follow in the picture, and their depth is
/// the user's.
enum class CameraKnowledge { Tripod };

struct Shot
{
    int width = 0, height = 0;         // of the working copy
    int clipWidth = 0, clipHeight = 0; // pixels of the clip
    CameraKnowledge knowledge = CameraKnowledge::Tripod;
    std::vector<ShotCamera> cameras;   // one a frame
    double sceneDepth = 10.0;          // where nothing is known; scene units
    std::vector<FlowField> forward;    // from frame t to t + 1
    std::vector<FlowField> backward;   // from frame t + 1 to t
    std::vector<FeatureGrid> features; // one a frame

    int frameCount() const { return int(cameras.size()); }
    double depthAt(int frame, const Vec2 &pixel) const;
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
