#include "doodling/tracking/track_point.h"

#include "doodling/tracking/motion_between.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr char attempted[] = "Following the canvas";

Result<void> checkKeyframes(const Shot &shot, const std::vector<CanvasKeyframe> &keyframes)
{
    int last = -1;
    for (const CanvasKeyframe &key : keyframes) {
        const std::string name = "the keyframe at frame " + std::to_string(key.frame);
        if (key.frame <= last || key.frame >= shot.frameCount())
            return Error{ErrorCode::InvalidArgument, attempted, name + " is out of order or beyond the clip",
                         "Give each frame one keyframe, in order", ""};
        if (!key.pixel.allFinite() || (key.depth && !(*key.depth > 0.0 && std::isfinite(*key.depth))))
            return Error{ErrorCode::InvalidArgument, attempted, name + " has no place in the picture",
                         "Set it again", ""};
        last = key.frame;
    }
    if (keyframes.empty())
        return Error{ErrorCode::InvalidArgument, attempted, "there is no keyframe",
                     "Place the canvas in a frame", ""};
    return {};
}

void interpolate(const CanvasKeyframe &from, const CanvasKeyframe &to, std::vector<PathPoint> &path)
{
    const PathPoint start = path[std::size_t(from.frame)];
    for (int t = from.frame + 1; t <= to.frame; ++t) {
        const double share = double(t - from.frame) / double(to.frame - from.frame);
        PathPoint &point = path[std::size_t(t)];
        point = start;
        point.pixel = (1.0 - share) * from.pixel + share * to.pixel;
    }
}

// The whole way in the picture: from keyframe to keyframe, and on from the first and the last one.
std::vector<PathPoint> wholePath(const Shot &shot, const std::vector<CanvasKeyframe> &keyframes,
                                 const PixelPathOptions &options)
{
    std::vector<PathPoint> path(std::size_t(shot.frameCount()));
    const auto pixelKeyframe = [](const CanvasKeyframe &key) { return PixelKeyframe{key.frame, key.pixel}; };
    const CanvasKeyframe &first = keyframes.front();
    const std::vector<PathPoint> before = pixelPath(shot, pixelKeyframe(first), {}, 0, options);
    for (std::size_t i = 0; i < before.size(); ++i)
        path[std::size_t(first.frame) - i] = before[i];
    for (std::size_t k = 0; k < keyframes.size(); ++k) {
        const bool isLast = k + 1 == keyframes.size();
        if (!isLast && keyframes[k].interpolatesNext) {
            interpolate(keyframes[k], keyframes[k + 1], path);
            continue;
        }
        const std::optional<PixelKeyframe> to =
            isLast ? std::nullopt : std::optional(pixelKeyframe(keyframes[k + 1]));
        const std::vector<PathPoint> part =
            pixelPath(shot, pixelKeyframe(keyframes[k]), to, shot.frameCount() - 1, options);
        const PathPoint start = path[std::size_t(keyframes[k].frame)];
        for (std::size_t i = 0; i < part.size(); ++i) {
            PathPoint &point = path[std::size_t(keyframes[k].frame) + i];
            point = part[i];
            point.turn += start.turn;
            point.growth *= start.growth;
        }
    }
    return path;
}

std::vector<PositionKeyframe> raysOf(const Shot &shot, const std::vector<CanvasKeyframe> &keyframes)
{
    std::vector<PositionKeyframe> rays;
    for (const CanvasKeyframe &key : keyframes) {
        const ShotCamera &camera = shot.cameras[std::size_t(key.frame)];
        rays.push_back({key.frame, camera.position(), camera.rayOf(key.pixel),
                        key.depth ? *key.depth : shot.depthAt(key.frame, key.pixel), key.depth.has_value(),
                        key.interpolatesNext});
    }
    return rays;
}

// Scene flow along the path (thesis VI.5.2): from the one frame's place in the scene to the next one's.
std::vector<FlowStep> sceneSteps(const Shot &shot, const std::vector<PathPoint> &path,
                                 const TrackOptions &options)
{
    std::vector<MeasuredDepth> measured;
    for (int t = 0; t < shot.frameCount(); ++t) {
        const PathPoint &point = path[std::size_t(t)];
        measured.push_back({shot.depthAt(t, point.pixel), point.isVisible ? 1.0 : options.hiddenWeight});
    }
    const std::vector<double> depths = smoothedDepths(measured, options.depth);
    std::vector<Vec3> places;
    for (std::size_t t = 0; t < path.size(); ++t)
        places.push_back(shot.cameras[t].unprojected(path[t].pixel, depths[t]));
    std::vector<FlowStep> steps;
    for (std::size_t t = 0; t + 1 < path.size(); ++t) {
        const bool isSeen = path[t].isVisible && path[t + 1].isVisible;
        steps.push_back({places[t + 1] - places[t], isSeen ? 1.0 : options.hiddenWeight});
    }
    return steps;
}

// Whether the picture's path rules there: not between keyframes that are joined in a straight line.
bool isTracked(const std::vector<CanvasKeyframe> &keyframes, int frame)
{
    for (std::size_t k = 0; k + 1 < keyframes.size(); ++k)
        if (keyframes[k].interpolatesNext && frame > keyframes[k].frame && frame < keyframes[k + 1].frame)
            return false;
    return true;
}

std::vector<TrackedPoint> seen(const Shot &shot, const std::vector<CanvasKeyframe> &keyframes,
                               const std::vector<PathPoint> &path, const std::vector<Vec3> &positions,
                               const TrackOptions &options)
{
    std::vector<TrackedPoint> points;
    for (int t = 0; t < shot.frameCount(); ++t) {
        const ShotCamera &camera = shot.cameras[std::size_t(t)];
        const PathPoint &place = path[std::size_t(t)];
        TrackedPoint point;
        point.turn = place.turn;
        point.growth = place.growth;
        point.depth = camera.depthOf(positions[std::size_t(t)]);
        if (isTracked(keyframes, t)) {
            point.depth = std::max(point.depth, options.trajectory.nearestDepth);
            point.pixel = place.pixel;
            point.position = camera.unprojected(place.pixel, point.depth);
            point.isVisible = place.isVisible;
        } else {
            point.position = positions[std::size_t(t)];
            const std::optional<Vec2> pixel = camera.projected(point.position);
            point.pixel = pixel.value_or(Vec2(-1.0, -1.0));
            point.isVisible = pixel && isInside(shot, *pixel);
        }
        points.push_back(point);
    }
    return points;
}

} // namespace

Result<std::vector<TrackedPoint>> trackPoint(const Shot &shot, const std::vector<CanvasKeyframe> &keyframes,
                                             const TrackOptions &options, const JobControl &control)
{
    if (Result<void> checked = checkKeyframes(shot, keyframes); !checked)
        return checked.error();
    if (control.isCancelled())
        return cancelledError(attempted);
    const std::vector<PathPoint> path = wholePath(shot, keyframes, options.path);
    if (control.isCancelled())
        return cancelledError(attempted);
    const Result<std::vector<Vec3>> positions =
        solveTrajectory(sceneSteps(shot, path, options), raysOf(shot, keyframes), options.trajectory);
    if (!positions)
        return positions.error();
    return seen(shot, keyframes, path, *positions, options);
}

} // namespace ductus
