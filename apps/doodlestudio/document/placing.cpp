#include "doodlestudio/document/placing.h"

#include "doodling/canvas/edit_scene.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double smallestBox = 12.0;      // working pixels; less is a click
constexpr double clickedShare = 0.36;     // of the picture's height
constexpr double clickedProportion = 1.4; // width by height

} // namespace

Canvas canvasInBox(const Shot &shot, int frame, const Vec2 &corner, const Vec2 &opposite,
                   const std::string &name)
{
    Vec2 pixels = (opposite - corner).cwiseAbs();
    const Vec2 middle = 0.5 * (corner + opposite);
    if (pixels.x() < smallestBox || pixels.y() < smallestBox)
        pixels = Vec2(clickedProportion, 1.0) * (clickedShare * shot.height);
    const double depth = shot.depthAt(frame, middle);
    Canvas canvas;
    canvas.name = name;
    // Facing the camera: a pixel is depth / focal wide.
    canvas.size = pixels * (depth / shot.cameras[std::size_t(frame)].focal);
    CanvasKeyframe place;
    place.frame = frame;
    place.pixel = middle;
    canvas.keyframes.positions = {place};
    return canvas;
}

Canvas propInBox(const Shot &shot, int frame, const Vec2 &corner, const Vec2 &opposite, Prop prop,
                 std::optional<double> distance)
{
    Canvas canvas = canvasInBox(shot, frame, corner, opposite, prop.link.name);
    const double focal = shot.cameras[std::size_t(frame)].focal;
    const Vec2 middle = canvas.keyframes.positions.front().pixel;
    const Vec2 pixels = canvas.size * (focal / shot.depthAt(frame, middle));
    const Vec2 foot = middle + Vec2(0.0, 0.5 * pixels.y());
    const Vec2 seenFoot(std::clamp(foot.x(), 0.5, shot.width - 0.5),
                        std::clamp(foot.y(), 0.5, shot.height - 0.5));
    const double depth = distance.value_or(shot.depthAt(frame, seenFoot));
    canvas.size = pixels * (depth / focal);
    canvas.keyframes.depths = {{frame, depth}};
    prop.placement = standingOnSheet(prop.painting->painting(), canvas.size);
    canvas.prop = std::make_shared<const Prop>(std::move(prop));
    return canvas;
}

Result<Canvas> withMiddleAt(const Canvas &canvas, int frame, const Vec2 &pixel)
{
    CanvasKeyframe place;
    place.frame = frame;
    place.pixel = pixel;
    for (const CanvasKeyframe &known : canvas.keyframes.positions) {
        if (known.frame == frame || canvas.motion == CanvasMotion::Static) {
            place.depth = known.depth;
            place.interpolatesNext = known.interpolatesNext;
            break;
        }
    }
    if (canvas.motion == CanvasMotion::Dynamic)
        return withPosition(canvas, place);
    Canvas moved = canvas;
    moved.keyframes.positions = {place};
    return moved;
}

Result<Canvas> withTurnAt(const Canvas &canvas, int frame, const Eigen::Quaterniond &worldFromCanvas)
{
    TurnKeyframe turn;
    turn.frame = frame;
    turn.worldFromCanvas = worldFromCanvas;
    for (const TurnKeyframe &known : canvas.keyframes.turns)
        if (known.frame == frame)
            turn.interpolatesNext = known.interpolatesNext;
    if (canvas.motion == CanvasMotion::Dynamic)
        return withTurn(canvas, turn);
    Canvas turned = canvas;
    turned.keyframes.turns = {turn};
    return turned;
}

Result<Canvas> withDistanceAt(const Canvas &canvas, int frame, double depth)
{
    if (canvas.motion == CanvasMotion::Dynamic)
        return withDepth(canvas, {frame, depth});
    // A standing canvas lies where its place's frame says.
    Canvas moved = canvas;
    moved.keyframes.depths.clear();
    return withDepth(moved, {canvas.keyframes.positions.front().frame, depth});
}

Result<Canvas> withScaleAt(const Canvas &canvas, int frame, double scale)
{
    if (canvas.motion == CanvasMotion::Dynamic && !canvas.keyframes.scales.empty())
        return withScale(canvas, {frame, scale});
    Canvas scaled = canvas;
    scaled.keyframes.scales = {{canvas.keyframes.positions.front().frame, scale}};
    return scaled;
}

Canvas withSceneDistance(const Canvas &canvas)
{
    Canvas changed = canvas;
    changed.keyframes.depths.clear();
    for (CanvasKeyframe &place : changed.keyframes.positions)
        place.depth.reset();
    return changed;
}

Canvas following(const Canvas &canvas, int frame, const CanvasFrame &place)
{
    Canvas pinned = canvas;
    pinned.motion = CanvasMotion::Dynamic;
    pinned.turning = CanvasTurning::AlongPath;
    CanvasKeyframe key;
    key.frame = frame;
    key.pixel = place.pixel;
    pinned.keyframes.positions = {key};
    // What the user set by hand stays set; what the scene gave is asked of it again.
    if (!pinned.keyframes.depths.empty())
        pinned.keyframes.depths = {{frame, place.depth}};
    if (!pinned.keyframes.turns.empty())
        pinned.keyframes.turns = {{frame, place.worldFromCanvas, false}};
    return pinned;
}

Canvas standingAt(const Canvas &canvas, int frame, const CanvasFrame &place)
{
    Canvas standing = canvas;
    standing.motion = CanvasMotion::Static;
    standing.turning = CanvasTurning::Still;
    CanvasKeyframe key;
    key.frame = frame;
    key.pixel = place.pixel;
    standing.keyframes.positions = {key};
    standing.keyframes.depths = {{frame, place.depth}};
    standing.keyframes.turns = {{frame, place.worldFromCanvas, false}};
    standing.keyframes.scales = {{frame, place.scale}};
    return standing;
}

Vec3 frontInCamera(const Eigen::Quaterniond &worldFromCanvas, const ShotCamera &camera)
{
    // Canvas axes: z goes away from who looks at its front.
    return (camera.worldFromCamera.linear().transpose() * (worldFromCanvas * Vec3(0.0, 0.0, -1.0)))
        .normalized();
}

Eigen::Quaterniond tilted(const Eigen::Quaterniond &worldFromCanvas, const ShotCamera &camera,
                          const Vec3 &towardsCamera)
{
    const Eigen::Quaterniond worldFromCamera(camera.worldFromCamera.linear());
    const Eigen::Quaterniond tilt =
        Eigen::Quaterniond::FromTwoVectors(frontInCamera(worldFromCanvas, camera), towardsCamera);
    return (worldFromCamera * tilt * worldFromCamera.conjugate() * worldFromCanvas).normalized();
}

Eigen::Quaterniond spun(const Eigen::Quaterniond &worldFromCanvas, double radians)
{
    // x right, y down: a positive turn about z is clockwise as seen.
    return (worldFromCanvas * Eigen::Quaterniond(Eigen::AngleAxisd(radians, Vec3::UnitZ()))).normalized();
}

} // namespace ductus
