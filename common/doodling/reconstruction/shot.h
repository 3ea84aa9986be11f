// What is known of a filmed scene: cameras, depth, motion and looks of every frame (thesis VI.5.1). Made once
// a clip by reconstructShot; the stages above and all drawing read from it. Motion and depth of a long clip
// lie in files of the cache and come into memory where they are read.
//
// All pixels are those of the working copy (at most 480 lines), not of the clip.
#pragma once

#include "doodling/cache/analysis_cache.h"
#include "doodling/cache/mapped_file.h"
#include "doodling/clip/clip.h"
#include "doodling/reconstruction/depth_map.h"
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
    double nearestDisparity = 0.0;      // 1 / scene unit: nothing that stands still is nearer; 0: not known
    std::vector<DepthMap> depths;       // one a frame, or none: all is at sceneDepth
    std::vector<CompactFlow> forward;   // from frame t to t + 1
    std::vector<CompactFlow> backward;  // from frame t + 1 to t
    LongFlows longFlows;                // between frames further apart; may be none
    std::vector<SmallPicture> pictures; // one a frame, or none

    // What the arrays lie in, one a frame; none where all is in memory.
    std::vector<std::shared_ptr<const MappedFile>> motionFiles, depthFiles;

    int frameCount() const { return int(cameras.size()); }
    /// Motion is known; without it there are cameras and nothing else. A single picture has none.
    bool isAnalysed() const { return frameCount() == 1 || !forward.empty(); }
    /// Depth comes from elsewhere: it stays with the project and is not found again.
    bool isDepthGiven = false;
    /// It was found out once and is in the cache or has to be found again: see shotFromCache.
    bool isLeftInCache = false;
    /// Found again in the cache, so that a project need not hold it.
    bool isCached() const { return !motionFiles.empty(); }
    /// Gives back the memory of frames first..last, as far as they lie in files. For passes over long clips.
    void forgetPages(int first, int last) const;
    /// Along z of the frame's camera, scene units; always positive and finite.
    double depthAt(int frame, const Vec2 &pixel) const;
    /// The number of the object there that moves by itself; 0 for what stands still and where nobody knows.
    int objectAt(int frame, const Vec2 &pixel) const;
    /// Working pixels a pixel of the clip is wide.
    double scale() const { return clipWidth > 0 ? double(width) / clipWidth : 1.0; }
};

/// What an analysis had to do; the rest was there from an earlier one.
struct AnalysisReport
{
    int frames = 0, motionsMade = 0, depthsMade = 0;
    int damaged = 0; // pieces of the cache that had to be made again
};

struct ShotOptions
{
    int mostLines = 480; // of the working copy
    FlowOptions flow;
    AnalysisCache cache;         // off: all is held in memory
    std::string clipDigest;      // clipDigest() of the clip; needed with a cache
    const Shot *known = nullptr; // has cameras, scale and perhaps given depth: taken as they are
    AnalysisReport *report = nullptr;
    std::vector<ShotCamera> givenCameras; // one a frame, pixels of the clip; none: they are found
};

/// Reads the clip from front to back, once for motion and twice for depth. With a cache what was found is
/// kept frame by frame, and a run that was stopped goes on where it was; memory does not grow with the clip
/// but for cameras and point tracks. Errors: those of the clip, WriteFailed for the cache.
Result<Shot> reconstructShot(Clip &clip, const ShotOptions &options, const JobControl &control);

/// The shot whose cameras are \a options.known as an earlier run left it in the cache; nothing if anything of
/// it is missing or damaged: reconstructShot then makes what is missing.
std::optional<Shot> shotFromCache(const ShotOptions &options, const JobControl &control);

} // namespace ductus
