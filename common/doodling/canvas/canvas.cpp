#include "doodling/canvas/canvas.h"

#include <algorithm>

namespace ductus {

namespace {

// One place in the world for all frames.
CanvasTrack standing(const Shot &shot, const Canvas &canvas)
{
    const CanvasKeyframes &keyframes = canvas.keyframes;
    const CanvasKeyframe &first = keyframes.positions.front();
    const ShotCamera &camera = shot.cameras[std::size_t(first.frame)];
    const double depth = !keyframes.depths.empty() ? keyframes.depths.front().depth
                         : first.depth             ? *first.depth
                                                   : shot.depthAt(first.frame, first.pixel);
    CanvasFrame place;
    place.position = camera.unprojected(first.pixel, depth);
    place.worldFromCanvas = keyframes.turns.empty() ? Eigen::Quaterniond(camera.worldFromCamera.linear())
                                                    : keyframes.turns.front().worldFromCanvas.normalized();
    place.scale = keyframes.scales.empty() ? 1.0 : keyframes.scales.front().scale;
    CanvasTrack track;
    for (int t = 0; t < shot.frameCount(); ++t) {
        const ShotCamera &seenBy = shot.cameras[std::size_t(t)];
        CanvasFrame frame = place;
        frame.depth = seenBy.depthOf(place.position);
        const std::optional<Vec2> pixel = seenBy.projected(place.position);
        frame.pixel = pixel.value_or(Vec2(-1e4, -1e4));
        frame.isVisible = pixel && pixel->x() >= 0.0 && pixel->y() >= 0.0 && pixel->x() <= shot.width &&
                          pixel->y() <= shot.height;
        track.frames.push_back(frame);
    }
    return track;
}

} // namespace

const Canvas *DoodleScene::find(CanvasId id) const
{
    const auto found =
        std::find_if(canvases.begin(), canvases.end(), [&](const Canvas &canvas) { return canvas.id == id; });
    return found == canvases.end() ? nullptr : &*found;
}

Result<CanvasTrack> canvasTrack(const Shot &shot, const Canvas &canvas, const JobControl &control)
{
    const auto refused = [&](const std::string &problem) {
        return Error{ErrorCode::InvalidArgument, "Placing the canvas", problem, "Place it anew", canvas.name};
    };
    if (canvas.keyframes.positions.empty())
        return refused("it has no place in any frame");
    if (canvas.motion == CanvasMotion::Dynamic) {
        CanvasTrackOptions options;
        options.turning = canvas.turning;
        return trackCanvas(shot, canvas.keyframes, options, control);
    }
    const int frame = canvas.keyframes.positions.front().frame;
    if (frame < 0 || frame >= shot.frameCount())
        return refused("its keyframe is beyond the clip");
    return standing(shot, canvas);
}

bool isShownIn(const Canvas &canvas, int videoFrame)
{
    return canvas.isVisible && canvas.opacity > 0.0 && videoFrame >= canvas.shownFrom &&
           (canvas.shownUntil < 0 || videoFrame <= canvas.shownUntil);
}

} // namespace ductus
