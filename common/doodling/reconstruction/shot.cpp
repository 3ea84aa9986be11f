#include "doodling/reconstruction/shot.h"

#include "doodling/reconstruction/cameras/solve_cameras.h"
#include "doodling/reconstruction/depth/shot_depth.h"
#include "doodling/reconstruction/motion_reader.h"

namespace ductus {

namespace {

constexpr char attempted[] = "Finding how the scene moves";

// Flow, features and corners: one pass over the clip.
Result<std::vector<PointTrack>> followPictures(Clip &clip, const ShotOptions &options, Shot &shot,
                                               const JobControl &control)
{
    PointTracker tracker;
    MotionReader motion(clip.info().frameCount, options.flow);
    Image before;
    for (int t = 0; t < clip.info().frameCount; ++t) {
        if (control.isCancelled())
            return cancelledError(attempted);
        control.progress(double(t) / clip.info().frameCount, attempted);
        Result<Image> frame = clip.frame(t, options.mostLines);
        if (!frame)
            return frame.error();
        motion.add(*frame, shot);
        tracker.add(*frame, t > 0 ? &shot.forward.back() : nullptr);
        before = std::move(*frame);
    }
    shot.width = before.width;
    shot.height = before.height;
    return tracker.takeTracks();
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

Result<Shot> reconstructShot(Clip &clip, const ShotOptions &options, const JobControl &control)
{
    Shot shot;
    shot.clipWidth = clip.info().width;
    shot.clipHeight = clip.info().height;
    const Result<std::vector<PointTrack>> tracks =
        followPictures(clip, options, shot, control.part(0.0, 0.7));
    if (!tracks)
        return tracks.error();
    CameraSolution solution =
        solveCameras(*tracks, clip.info().frameCount, shot.width, shot.height, {}, control.part(0.7, 0.8));
    if (control.isCancelled())
        return cancelledError(attempted);
    shot.knowledge = solution.knowledge;
    shot.cameras = std::move(solution.cameras);
    if (Result<void> found =
            findDepth(clip, solution.points, options.mostLines, shot, control.part(0.8, 1.0));
        !found)
        return found.error();
    return shot;
}

} // namespace ductus
