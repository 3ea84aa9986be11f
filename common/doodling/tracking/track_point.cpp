#include "doodling/tracking/track_point.h"

#include "doodling/tracking/similar_cells.h"

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

// Where what is seen at a pixel goes to until the next frame, and how far that is trusted.
FlowStep sceneFlow(const Shot &shot, int frame, const Vec2 &pixel)
{
    const FlowField &flow = shot.forward[std::size_t(frame)];
    const Vec2 next = pixel + flow.motionAt(pixel);
    const Vec3 from = shot.cameras[std::size_t(frame)].unprojected(pixel, shot.depthAt(frame, pixel));
    const Vec3 to = shot.cameras[std::size_t(frame) + 1].unprojected(next, shot.depthAt(frame + 1, next));
    return {to - from, std::max(1e-3, flow.confidenceAt(pixel))};
}

// Squared scene units of a jump of so many cells at the first keyframe: costs must not depend on how deep a
// scene is.
double jumpCost(const Shot &shot, const CanvasKeyframe &key, double cells)
{
    const double pixels = cells * shot.features[std::size_t(key.frame)].cellSize;
    const double jump =
        pixels * shot.depthAt(key.frame, key.pixel) / shot.cameras[std::size_t(key.frame)].focal;
    return jump * jump;
}

std::vector<std::vector<PathCell>> layersOf(const Shot &shot, const std::vector<CanvasKeyframe> &keyframes,
                                            const TrackOptions &options)
{
    const std::vector<std::vector<int>> cells = similarCells(shot, keyframes, options.keptShare);
    const double unsafeCost = jumpCost(shot, keyframes.front(), options.unsafeJump);
    std::vector<std::vector<PathCell>> layers(cells.size());
    for (int t = 0; t < shot.frameCount(); ++t) {
        const FeatureGrid &grid = shot.features[std::size_t(t)];
        for (int cell : cells[std::size_t(t)]) {
            const Vec2 pixel = Vec2(cell % grid.width + 0.5, cell / grid.width + 0.5) * grid.cellSize;
            PathCell node;
            node.place = shot.cameras[std::size_t(t)].unprojected(pixel, shot.depthAt(t, pixel));
            if (t + 1 < shot.frameCount()) {
                const FlowStep step = sceneFlow(shot, t, pixel);
                node.motion = step.motion;
                node.cost = unsafeCost * (1.0 - step.confidence);
            }
            layers[std::size_t(t)].push_back(node);
        }
    }
    for (const CanvasKeyframe &key : keyframes) {
        PathCell &node = layers[std::size_t(key.frame)].front();
        const double depth = key.depth ? *key.depth : shot.depthAt(key.frame, key.pixel);
        node.place = shot.cameras[std::size_t(key.frame)].unprojected(key.pixel, depth);
        node.isKeyframed = true;
        node.cost = 0.0;
    }
    return layers;
}

// The same step looked at from its end: what is seen at a pixel of frame + 1, where did it come from.
FlowStep sceneFlowBackwards(const Shot &shot, int frame, const Vec2 &pixelAfter)
{
    const FlowField &flow = shot.backward[std::size_t(frame)];
    const Vec2 before = pixelAfter + flow.motionAt(pixelAfter);
    const Vec3 to =
        shot.cameras[std::size_t(frame) + 1].unprojected(pixelAfter, shot.depthAt(frame + 1, pixelAfter));
    const Vec3 from = shot.cameras[std::size_t(frame)].unprojected(before, shot.depthAt(frame, before));
    return {to - from, std::max(1e-3, flow.confidenceAt(pixelAfter))};
}

// Whether the rough path is hidden at either end of the step from \a frame: what moves at that pixel is
// something else.
bool isHidden(const LayeredPath &path, int frame)
{
    return path.cells[std::size_t(frame)] < 0 || path.cells[std::size_t(frame) + 1] < 0;
}

// Scene flow along the present trajectory, from both ends of each step: where something is covered or
// uncovered one of them is wrong and says so.
std::vector<FlowStep> sampledFlow(const Shot &shot, const std::vector<Vec3> &positions,
                                  const LayeredPath &path)
{
    std::vector<FlowStep> steps;
    for (int t = 0; t + 1 < shot.frameCount(); ++t) {
        if (isHidden(path, t)) {
            steps.push_back({path.places[std::size_t(t) + 1] - path.places[std::size_t(t)], 1e-3});
            continue;
        }
        const std::optional<Vec2> here = shot.cameras[std::size_t(t)].projected(positions[std::size_t(t)]);
        const std::optional<Vec2> there =
            shot.cameras[std::size_t(t) + 1].projected(positions[std::size_t(t) + 1]);
        FlowStep ahead{Vec3::Zero(), 1e-3}, back{Vec3::Zero(), 1e-3};
        if (here)
            ahead = sceneFlow(shot, t, *here);
        if (there)
            back = sceneFlowBackwards(shot, t, *there);
        const double sum = ahead.confidence + back.confidence;
        steps.push_back({(ahead.confidence * ahead.motion + back.confidence * back.motion) / sum,
                         std::max(ahead.confidence, back.confidence)});
    }
    return steps;
}

// The flow followed from a keyframe through one frame after the other; where it is not trusted the rough
// path's motion is taken.
void follow(const Shot &shot, const LayeredPath &path, const TrackOptions &options, int from, int to,
            std::vector<Vec3> &positions)
{
    const int step = to > from ? 1 : -1;
    for (int t = from; t != to; t += step) {
        const Vec3 &place = positions[std::size_t(t)];
        const Vec3 rough = path.places[std::size_t(t + step)] - path.places[std::size_t(t)];
        const std::optional<Vec2> pixel = shot.cameras[std::size_t(t)].projected(place);
        FlowStep flow{Vec3::Zero(), 0.0};
        if (pixel)
            flow = step > 0 ? sceneFlow(shot, t, *pixel) : sceneFlowBackwards(shot, t - 1, *pixel);
        const bool isTrusted =
            !isHidden(path, std::min(t, t + step)) && flow.confidence >= options.followedFrom;
        positions[std::size_t(t + step)] = place + (isTrusted ? Vec3(step * flow.motion) : rough);
    }
}

// Followed from the keyframe before and the one after, mixed by nearness.
std::vector<Vec3> followedFromKeyframes(const Shot &shot, const std::vector<CanvasKeyframe> &keyframes,
                                        const LayeredPath &path, const TrackOptions &options)
{
    std::vector<Vec3> ahead = path.places, back = path.places;
    const int last = shot.frameCount() - 1;
    for (std::size_t k = 0; k < keyframes.size(); ++k) {
        const int frame = keyframes[k].frame;
        const int next = k + 1 < keyframes.size() ? keyframes[k + 1].frame - 1 : last;
        const int before = k > 0 ? keyframes[k - 1].frame + 1 : 0;
        if (next > frame)
            follow(shot, path, options, frame, next, ahead);
        if (before < frame)
            follow(shot, path, options, frame, before, back);
    }
    std::vector<Vec3> positions = ahead;
    for (int t = 0; t < keyframes.front().frame; ++t)
        positions[std::size_t(t)] = back[std::size_t(t)];
    for (std::size_t k = 0; k + 1 < keyframes.size(); ++k)
        for (int t = keyframes[k].frame + 1; t < keyframes[k + 1].frame; ++t) {
            const double share =
                double(t - keyframes[k].frame) / double(keyframes[k + 1].frame - keyframes[k].frame);
            positions[std::size_t(t)] = (1.0 - share) * ahead[std::size_t(t)] + share * back[std::size_t(t)];
        }
    return positions;
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

std::vector<TrackedPoint> seen(const Shot &shot, const std::vector<Vec3> &positions, const LayeredPath &path)
{
    std::vector<TrackedPoint> points;
    for (int t = 0; t < shot.frameCount(); ++t) {
        const ShotCamera &camera = shot.cameras[std::size_t(t)];
        TrackedPoint point;
        point.position = positions[std::size_t(t)];
        point.depth = camera.depthOf(point.position);
        const std::optional<Vec2> pixel = camera.projected(point.position);
        point.pixel = pixel.value_or(Vec2(-1.0, -1.0));
        point.isVisible = pixel && path.cells[std::size_t(t)] >= 0 && pixel->x() >= 0.0 &&
                          pixel->y() >= 0.0 && pixel->x() < shot.width && pixel->y() < shot.height;
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
    const LayeredPathOptions pathOptions{jumpCost(shot, keyframes.front(), options.hiddenJump),
                                         options.hiddenPoints, options.longestHidden};
    const Result<LayeredPath> path = shortestPath(layersOf(shot, keyframes, options), pathOptions, control);
    if (!path)
        return path.error();
    const std::vector<PositionKeyframe> rays = raysOf(shot, keyframes);
    std::vector<Vec3> positions = followedFromKeyframes(shot, keyframes, *path, options);
    for (int sampling = 0; sampling < options.samplings; ++sampling) {
        Result<std::vector<Vec3>> solved =
            solveTrajectory(sampledFlow(shot, positions, *path), rays, options.trajectory);
        if (!solved)
            return solved.error();
        positions = std::move(*solved);
    }
    return seen(shot, positions, *path);
}

} // namespace ductus
