#include "doodling/canvas/edit_scene.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

Error refused(const std::string &attempted, const std::string &problem, const std::string &remedy = "")
{
    return {ErrorCode::InvalidArgument, attempted, problem, remedy, ""};
}

Result<void> check(const Canvas &canvas)
{
    const char *attempted = "Changing the canvas";
    if (canvas.keyframes.positions.empty())
        return refused(attempted, "it has no place in any frame");
    if (!canvas.size.allFinite() || !(canvas.size.minCoeff() > 0.0))
        return refused(attempted, "its size is not positive");
    if (!(canvas.opacity >= 0.0 && canvas.opacity <= 1.0))
        return refused(attempted, "its opacity is not between 0 and 1");
    if (canvas.prop && !propProblem(*canvas.prop).empty())
        return refused(attempted, propProblem(*canvas.prop));
    if (canvas.doodle.frames.empty())
        return refused(attempted, "its doodle has no frame");
    for (const DoodleFrame &frame : canvas.doodle.frames)
        if (frame.hold < 1)
            return refused(attempted, "a frame of its doodle is shown for no time");
    return {};
}

auto placeOf(std::vector<Canvas> &canvases, CanvasId id)
{
    return std::find_if(canvases.begin(), canvases.end(), [&](const Canvas &c) { return c.id == id; });
}

template <typename Keyframe>
auto placeAt(std::vector<Keyframe> &keyframes, int frame)
{
    return std::lower_bound(keyframes.begin(), keyframes.end(), frame,
                            [](const Keyframe &key, int f) { return key.frame < f; });
}

template <typename Keyframe>
bool hasAt(std::vector<Keyframe> &keyframes, int frame)
{
    const auto place = placeAt(keyframes, frame);
    return place != keyframes.end() && place->frame == frame;
}

template <typename Keyframe>
void put(std::vector<Keyframe> &keyframes, const Keyframe &keyframe)
{
    if (hasAt(keyframes, keyframe.frame))
        *placeAt(keyframes, keyframe.frame) = keyframe;
    else
        keyframes.insert(placeAt(keyframes, keyframe.frame), keyframe);
}

// Calls \a change with the list of \a kind.
template <typename Change>
Result<Canvas> changed(Canvas canvas, KeyframeKind kind, const Change &change)
{
    Result<void> done;
    switch (kind) {
    case KeyframeKind::Position:
        done = change(canvas.keyframes.positions);
        break;
    case KeyframeKind::Depth:
        done = change(canvas.keyframes.depths);
        break;
    case KeyframeKind::Turn:
        done = change(canvas.keyframes.turns);
        break;
    case KeyframeKind::Scale:
        done = change(canvas.keyframes.scales);
        break;
    }
    if (!done)
        return done.error();
    return canvas;
}

} // namespace

Result<DoodleScene> withCanvas(const DoodleScene &scene, Canvas canvas)
{
    if (Result<void> sound = check(canvas); !sound)
        return sound.error();
    std::int32_t next = 0;
    for (const Canvas &other : scene.canvases)
        next = std::max(next, other.id.value + 1);
    canvas.id = {next};
    DoodleScene result = scene;
    result.canvases.push_back(std::move(canvas));
    return result;
}

Result<DoodleScene> withChangedCanvas(const DoodleScene &scene, Canvas canvas)
{
    if (Result<void> sound = check(canvas); !sound)
        return sound.error();
    DoodleScene result = scene;
    const auto place = placeOf(result.canvases, canvas.id);
    if (place == result.canvases.end())
        return refused("Changing the canvas", "it is not there any more");
    *place = std::move(canvas);
    return result;
}

Result<DoodleScene> withoutCanvas(const DoodleScene &scene, CanvasId id)
{
    DoodleScene result = scene;
    const auto place = placeOf(result.canvases, id);
    if (place == result.canvases.end())
        return refused("Removing the canvas", "it is not there any more");
    result.canvases.erase(place);
    return result;
}

Result<DoodleScene> withMovedCanvas(const DoodleScene &scene, CanvasId id, int index)
{
    DoodleScene result = scene;
    const auto place = placeOf(result.canvases, id);
    if (place == result.canvases.end())
        return refused("Moving the canvas", "it is not there any more");
    if (index < 0 || index >= int(result.canvases.size()))
        return refused("Moving the canvas", "there is no such place in the order");
    Canvas canvas = std::move(*place);
    result.canvases.erase(place);
    result.canvases.insert(result.canvases.begin() + index, std::move(canvas));
    return result;
}

Result<Canvas> withPosition(const Canvas &canvas, const CanvasKeyframe &keyframe)
{
    if (keyframe.frame < 0 || !keyframe.pixel.allFinite())
        return refused("Pinning the canvas", "there is no such place");
    if (keyframe.depth && !(*keyframe.depth > 0.0 && std::isfinite(*keyframe.depth)))
        return refused("Pinning the canvas", "its depth is not positive");
    Canvas result = canvas;
    put(result.keyframes.positions, keyframe);
    return result;
}

Result<Canvas> withDepth(const Canvas &canvas, const DepthKeyframe &keyframe)
{
    if (keyframe.frame < 0 || !(keyframe.depth > 0.0 && std::isfinite(keyframe.depth)))
        return refused("Moving the canvas in depth", "its depth is not positive");
    Canvas result = canvas;
    put(result.keyframes.depths, keyframe);
    return result;
}

Result<Canvas> withTurn(const Canvas &canvas, const TurnKeyframe &keyframe)
{
    if (keyframe.frame < 0 || !(keyframe.worldFromCanvas.norm() > 1e-9) ||
        !keyframe.worldFromCanvas.coeffs().allFinite())
        return refused("Turning the canvas", "it is no turn");
    Canvas result = canvas;
    TurnKeyframe key = keyframe;
    key.worldFromCanvas.normalize();
    put(result.keyframes.turns, key);
    return result;
}

Result<Canvas> withScale(const Canvas &canvas, const ScaleKeyframe &keyframe)
{
    if (keyframe.frame < 0 || !(keyframe.scale > 0.0 && std::isfinite(keyframe.scale)))
        return refused("Scaling the canvas", "its scale is not positive");
    Canvas result = canvas;
    put(result.keyframes.scales, keyframe);
    return result;
}

Result<Canvas> withoutKeyframe(const Canvas &canvas, KeyframeKind kind, int frame)
{
    return changed(canvas, kind, [&](auto &keyframes) -> Result<void> {
        if (!hasAt(keyframes, frame))
            return refused("Removing the keyframe", "there is none in this frame");
        if (kind == KeyframeKind::Position && keyframes.size() == 1)
            return refused("Removing the keyframe", "the canvas would be nowhere",
                           "Remove the canvas, or move the keyframe");
        keyframes.erase(placeAt(keyframes, frame));
        return {};
    });
}

Result<Canvas> withMovedKeyframe(const Canvas &canvas, KeyframeKind kind, int from, int to)
{
    return changed(canvas, kind, [&](auto &keyframes) -> Result<void> {
        if (!hasAt(keyframes, from))
            return refused("Moving the keyframe", "there is none in this frame");
        if (to < 0 || (to != from && hasAt(keyframes, to)))
            return refused("Moving the keyframe", "there is already one in that frame");
        auto keyframe = *placeAt(keyframes, from);
        keyframes.erase(placeAt(keyframes, from));
        keyframe.frame = to;
        put(keyframes, keyframe);
        return {};
    });
}

Result<Canvas> withInterpolation(const Canvas &canvas, KeyframeKind kind, int frame, bool interpolates)
{
    return changed(canvas, kind, [&](auto &keyframes) -> Result<void> {
        if (!hasAt(keyframes, frame))
            return refused("Changing the keyframe", "there is none in this frame");
        auto &keyframe = *placeAt(keyframes, frame);
        if constexpr (requires { keyframe.interpolatesNext; })
            keyframe.interpolatesNext = interpolates;
        else
            return refused("Changing the keyframe", "depth and scale always go straight to the next one");
        return {};
    });
}

} // namespace ductus
