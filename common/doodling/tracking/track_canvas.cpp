#include "doodling/tracking/track_canvas.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ductus {

namespace {

using Quaternion = Eigen::Quaterniond;

Error unusable(const char *what, int frame, const std::string &problem)
{
    return {ErrorCode::InvalidArgument, "Following the canvas",
            "the " + std::string(what) + " keyframe at frame " + std::to_string(frame) + " " + problem,
            "Remove the keyframe and set it again", ""};
}

template <typename Keyframe, typename IsUsable>
Result<void> checkKeyframes(const std::vector<Keyframe> &keyframes, int frames, const char *what,
                            const IsUsable &isUsable)
{
    int last = -1;
    for (const Keyframe &key : keyframes) {
        if (key.frame <= last || key.frame >= frames)
            return unusable(what, key.frame, "is out of order or beyond the clip");
        if (!isUsable(key))
            return unusable(what, key.frame, "is no number that can be used");
        last = key.frame;
    }
    return {};
}

// All depths there are: those of the depth keyframes go before those in positions of the same frame.
std::vector<DepthKeyframe> allDepths(const CanvasKeyframes &keyframes)
{
    std::vector<DepthKeyframe> depths = keyframes.depths;
    for (const CanvasKeyframe &position : keyframes.positions)
        if (position.depth)
            depths.push_back({position.frame, *position.depth});
    std::stable_sort(depths.begin(), depths.end(),
                     [](const DepthKeyframe &a, const DepthKeyframe &b) { return a.frame < b.frame; });
    depths.erase(
        std::unique(depths.begin(), depths.end(),
                    [](const DepthKeyframe &a, const DepthKeyframe &b) { return a.frame == b.frame; }),
        depths.end());
    return depths;
}

// Positions with the depths of their frames: there the trajectory itself is solved through the point.
std::vector<CanvasKeyframe> positionsWithDepths(const CanvasKeyframes &keyframes,
                                                const std::vector<DepthKeyframe> &depths)
{
    std::vector<CanvasKeyframe> positions = keyframes.positions;
    for (CanvasKeyframe &position : positions)
        for (const DepthKeyframe &key : depths)
            if (key.frame == position.frame)
                position.depth = key.depth;
    return positions;
}

// Between values at keyframes, beyond them as at the nearest one.
template <typename Keyframe, typename Value>
double mixedAt(const std::vector<Keyframe> &keyframes, int frame, const Value &valueOf)
{
    const auto next = std::lower_bound(keyframes.begin(), keyframes.end(), frame,
                                       [](const Keyframe &key, int f) { return key.frame < f; });
    if (next == keyframes.begin())
        return valueOf(*next);
    if (next == keyframes.end())
        return valueOf(keyframes.back());
    const Keyframe &before = *std::prev(next);
    const double share = double(frame - before.frame) / double(next->frame - before.frame);
    return (1.0 - share) * valueOf(before) + share * valueOf(*next);
}

// Depth keyframes between positions: every point moves along its ray, so that the picture stays as it is. The
// share to move by goes evenly from keyframe to keyframe.
void moveToDepths(const Shot &shot, const std::vector<DepthKeyframe> &depths,
                  std::vector<TrackedPoint> &points)
{
    if (depths.empty())
        return;
    std::vector<DepthKeyframe> factors;
    for (const DepthKeyframe &key : depths) {
        const double tracked = points[std::size_t(key.frame)].depth;
        factors.push_back({key.frame, tracked > 0.0 ? std::log(key.depth / tracked) : 0.0});
    }
    for (int t = 0; t < int(points.size()); ++t) {
        TrackedPoint &point = points[std::size_t(t)];
        if (!(point.depth > 0.0))
            continue;
        const double factor =
            std::exp(mixedAt(factors, t, [](const DepthKeyframe &key) { return key.depth; }));
        const Vec3 eye = shot.cameras[std::size_t(t)].position();
        point.position = eye + factor * (point.position - eye);
        point.depth *= factor;
    }
}

std::vector<TurnKeyframe> turnsOf(const Shot &shot, const CanvasKeyframes &keyframes)
{
    if (!keyframes.turns.empty())
        return keyframes.turns;
    const int frame = keyframes.positions.front().frame;
    return {{frame, Quaternion(shot.cameras[std::size_t(frame)].worldFromCamera.linear()), false}};
}

Quaternion turnedBetween(const std::vector<TurnKeyframe> &turns, int frame)
{
    const auto next = std::lower_bound(turns.begin(), turns.end(), frame,
                                       [](const TurnKeyframe &key, int f) { return key.frame < f; });
    if (next == turns.begin())
        return next->worldFromCanvas;
    if (next == turns.end())
        return turns.back().worldFromCanvas;
    const TurnKeyframe &before = *std::prev(next);
    const double share = double(frame - before.frame) / double(next->frame - before.frame);
    return before.worldFromCanvas.slerp(share, next->worldFromCanvas);
}

// How far a thing that stands still would turn in the picture from frame \a from to \a to: the camera's roll.
double rollBetween(const Shot &shot, int from, int to)
{
    const Eigen::Matrix3d turned = shot.cameras[std::size_t(to)].worldFromCamera.linear().transpose() *
                                   shot.cameras[std::size_t(from)].worldFromCamera.linear();
    return std::atan2(turned(1, 0), turned(0, 0));
}

// The keyframe's orientation turned about the line of sight by what the thing turned since.
Quaternion turnedWithThing(const Shot &shot, const std::vector<TrackedPoint> &points, const TurnKeyframe &key,
                           int frame)
{
    const double seen = points[std::size_t(frame)].turn - points[std::size_t(key.frame)].turn;
    const Vec3 sight = shot.cameras[std::size_t(frame)].worldFromCamera.linear().col(2);
    return Quaternion(Eigen::AngleAxisd(seen - rollBetween(shot, key.frame, frame), sight)) *
           key.worldFromCanvas.normalized();
}

// From the keyframe before and the one after, the nearer one counting more.
Quaternion turnedWithThing(const Shot &shot, const std::vector<TrackedPoint> &points,
                           const std::vector<TurnKeyframe> &turns, int frame)
{
    const auto next = std::lower_bound(turns.begin(), turns.end(), frame,
                                       [](const TurnKeyframe &key, int f) { return key.frame < f; });
    if (next == turns.begin())
        return turnedWithThing(shot, points, *next, frame);
    const TurnKeyframe &before = *std::prev(next);
    const Quaternion ahead = turnedWithThing(shot, points, before, frame);
    if (next == turns.end())
        return ahead;
    const double share = double(frame - before.frame) / double(next->frame - before.frame);
    return ahead.slerp(share, turnedWithThing(shot, points, *next, frame));
}

// Size in the scene as a multiple of the canvas' own. With the thing: what is seen to grow and goes away
// meanwhile grows twice.
std::vector<double> scalesOf(const std::vector<TrackedPoint> &points, const CanvasKeyframes &keyframes,
                             bool followsSize)
{
    std::vector<ScaleKeyframe> logs = keyframes.scales;
    if (logs.empty())
        logs = {{keyframes.positions.front().frame, 1.0}};
    const auto thingAt = [&](int frame) {
        const TrackedPoint &point = points[std::size_t(frame)];
        return followsSize && point.depth > 0.0 ? std::log(point.growth * point.depth) : 0.0;
    };
    for (ScaleKeyframe &key : logs)
        key.scale = std::log(key.scale) - thingAt(key.frame);
    std::vector<double> scales;
    for (int t = 0; t < int(points.size()); ++t)
        scales.push_back(
            std::exp(mixedAt(logs, t, [](const ScaleKeyframe &key) { return key.scale; }) + thingAt(t)));
    return scales;
}

Result<std::vector<Quaternion>> turnedAlong(const std::vector<TrackedPoint> &points,
                                            const std::vector<TurnKeyframe> &turns,
                                            const OrientationOptions &options, const JobControl &control)
{
    std::vector<Vec3> trajectory;
    for (const TrackedPoint &point : points)
        trajectory.push_back(point.position);
    std::vector<OrientationKeyframe> keyframes;
    for (const TurnKeyframe &turn : turns)
        keyframes.push_back({turn.frame, turn.worldFromCanvas.normalized()});
    return solveOrientations(trajectory, keyframes, options, control);
}

Result<std::vector<Quaternion>> orientationsOf(const Shot &shot, const std::vector<TrackedPoint> &points,
                                               const std::vector<TurnKeyframe> &turns,
                                               const CanvasTrackOptions &options, const JobControl &control)
{
    std::vector<Quaternion> orientations(points.size());
    if (options.turning == CanvasTurning::AlongPath) {
        Result<std::vector<Quaternion>> solved = turnedAlong(points, turns, options.orientation, control);
        if (!solved)
            return solved.error();
        orientations = std::move(*solved);
    }
    for (int t = 0; t < int(points.size()); ++t) {
        const auto after = std::upper_bound(turns.begin(), turns.end(), t,
                                            [](int f, const TurnKeyframe &key) { return f < key.frame; });
        const bool isBetween = after != turns.begin() && after != turns.end();
        if (options.turning == CanvasTurning::Still || (isBetween && std::prev(after)->interpolatesNext))
            orientations[std::size_t(t)] = turnedBetween(turns, t);
        else if (options.turning == CanvasTurning::WithThing)
            orientations[std::size_t(t)] = turnedWithThing(shot, points, turns, t);
    }
    return orientations;
}

Result<void> check(const Shot &shot, const CanvasKeyframes &keyframes)
{
    const int frames = shot.frameCount();
    const auto isPositive = [](double value) { return std::isfinite(value) && value > 0.0; };
    if (Result<void> checked =
            checkKeyframes(keyframes.depths, frames, "depth",
                           [&](const DepthKeyframe &key) { return isPositive(key.depth); });
        !checked)
        return checked;
    if (Result<void> checked =
            checkKeyframes(keyframes.scales, frames, "size",
                           [&](const ScaleKeyframe &key) { return isPositive(key.scale); });
        !checked)
        return checked;
    return checkKeyframes(keyframes.turns, frames, "orientation", [](const TurnKeyframe &key) {
        const double norm = key.worldFromCanvas.norm();
        return std::isfinite(norm) && norm > 1e-9;
    });
}

} // namespace

Result<CanvasTrack> trackCanvas(const Shot &shot, const CanvasKeyframes &keyframes,
                                const CanvasTrackOptions &options, const JobControl &control)
{
    if (Result<void> checked = check(shot, keyframes); !checked)
        return checked.error();
    const std::vector<DepthKeyframe> depths = allDepths(keyframes);
    Result<std::vector<TrackedPoint>> points =
        trackPoint(shot, positionsWithDepths(keyframes, depths), options.track, control);
    if (!points)
        return points.error();
    moveToDepths(shot, depths, *points);
    const Result<std::vector<Quaternion>> orientations =
        orientationsOf(shot, *points, turnsOf(shot, keyframes), options, control);
    const std::vector<double> scales = scalesOf(*points, keyframes, options.followsSize);
    if (!orientations)
        return orientations.error();
    CanvasTrack track;
    for (int t = 0; t < shot.frameCount(); ++t) {
        const TrackedPoint &point = (*points)[std::size_t(t)];
        track.frames.push_back({point.position, point.pixel, point.depth, (*orientations)[std::size_t(t)],
                                scales[std::size_t(t)], point.isVisible});
    }
    return track;
}

} // namespace ductus
