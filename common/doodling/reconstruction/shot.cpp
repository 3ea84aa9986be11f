#include "doodling/reconstruction/shot.h"

#include "base/sha256.h"
#include "doodling/reconstruction/cameras/camera_record.h"
#include "doodling/reconstruction/cameras/solve_cameras.h"
#include "doodling/reconstruction/depth/scene_scale.h"
#include "doodling/reconstruction/depth/shot_depth.h"
#include "doodling/reconstruction/given/placed_cameras.h"
#include "doodling/reconstruction/shot_motion.h"

#include <cstdio>

namespace ductus {

namespace {

constexpr char attempted[] = "Finding how the scene moves";
// Counts up whenever the same clip would give other motion, cameras or depth.
constexpr int analysisVersion = 2;

std::string storeKey(const ShotOptions &options)
{
    char text[256];
    std::snprintf(text, sizeof text, "analysis %d of %s: %d lines, cells of %d, half trust %.9g %.9g, %d",
                  analysisVersion, options.clipDigest.c_str(), options.mostLines, options.flow.cellSize,
                  options.flow.halfTrust, options.flow.halfTrustShare, int(options.flow.isFullSize));
    return sha256Hex(std::as_bytes(std::span(text, std::char_traits<char>::length(text))));
}

void takeKnown(const Shot &known, Shot &shot)
{
    shot.knowledge = known.knowledge;
    shot.cameras = known.cameras;
    shot.sceneDepth = known.sceneDepth;
    shot.nearestDisparity = known.nearestDisparity;
    shot.isDepthGiven = known.isDepthGiven;
    if (known.isDepthGiven)
        shot.depths = known.depths;
}

// Cameras from the corners, in the scene's units.
Result<void> findCameras(const std::vector<PointTrack> &tracks, int frameCount, Shot &shot,
                         const JobControl &control)
{
    CameraSolution solution = solveCameras(tracks, frameCount, shot.width, shot.height, {}, control);
    if (control.isCancelled())
        return cancelledError(attempted);
    shot.knowledge = solution.knowledge;
    shot.cameras = std::move(solution.cameras);
    scaleScene(solution.points, shot);
    return {};
}

Result<void> findMotionAndCameras(Clip &clip, const ShotOptions &options, ShotStore *store, Shot &shot,
                                  const JobControl &control)
{
    const int frames = clip.info().frameCount;
    const bool isGiven = !options.givenCameras.empty();
    DUCTUS_ASSERT(!isGiven || int(options.givenCameras.size()) == frames);
    const bool hasCameras = options.known || (store && !isGiven && takeCameras(*store, frames, shot));
    if (options.known)
        takeKnown(*options.known, shot);
    if (hasCameras && store && takeMotion(*store, frames, shot))
        return {};
    const Result<std::vector<PointTrack>> tracks =
        findMotion(clip, options, store, shot, control.part(0.0, 0.85));
    if (!tracks)
        return tracks.error();
    if (hasCameras)
        return {};
    if (isGiven) {
        placeGivenCameras(options.givenCameras, *tracks, shot);
        return {};
    }
    if (Result<void> found = findCameras(*tracks, frames, shot, control.part(0.85, 1.0)); !found)
        return found;
    return store ? keepCameras(*store, shot) : Result<void>();
}

} // namespace

double Shot::depthAt(int frame, const Vec2 &pixel) const
{
    return depths.empty() ? sceneDepth : depths[std::size_t(frame)].depthAt(pixel);
}

int Shot::objectAt(int frame, const Vec2 &pixel) const
{
    return depths.empty() ? 0 : depths[std::size_t(frame)].objectAt(pixel);
}

void Shot::forgetPages(int first, int last) const
{
    for (const auto *files : {&motionFiles, &depthFiles})
        for (int t = std::max(0, first); t <= last && t < int(files->size()); ++t)
            (*files)[std::size_t(t)]->forgetPages();
}

Result<Shot> reconstructShot(Clip &clip, const ShotOptions &options, const JobControl &control)
{
    Shot shot;
    shot.clipWidth = clip.info().width;
    shot.clipHeight = clip.info().height;
    std::optional<ShotStore> store;
    if (options.cache.isOn()) {
        Result<ShotStore> opened = ShotStore::open(options.cache, storeKey(options));
        if (!opened)
            return opened.error();
        store = std::move(*opened);
    }
    ShotStore *records = store ? &*store : nullptr;
    if (Result<void> found = findMotionAndCameras(clip, options, records, shot, control.part(0.0, 0.8));
        !found)
        return found.error();
    if (store)
        store->setCameraKey(cameraKey(shot));
    if (!shot.isDepthGiven)
        if (Result<void> found = findDepth(clip, options, records, shot, control.part(0.8, 1.0)); !found)
            return found.error();
    if (options.report) {
        options.report->frames = shot.frameCount();
        options.report->damaged = store ? store->damagedCount() : 0;
    }
    return shot;
}

std::optional<Shot> shotFromCache(const ShotOptions &options, const JobControl &control)
{
    DUCTUS_ASSERT(options.known);
    if (!options.cache.isOn() || options.clipDigest.empty())
        return std::nullopt;
    Result<ShotStore> store = ShotStore::open(options.cache, storeKey(options));
    if (!store)
        return std::nullopt; // the analysis that follows says why
    control.progress(0.0, "Reading what was found out about the clip");
    Shot shot;
    shot.clipWidth = options.known->clipWidth;
    shot.clipHeight = options.known->clipHeight;
    takeKnown(*options.known, shot);
    store->setCameraKey(cameraKey(shot));
    if (!takeMotion(*store, shot.frameCount(), shot) || (!shot.isDepthGiven && !takeDepth(*store, shot)))
        return std::nullopt;
    return shot;
}

} // namespace ductus
