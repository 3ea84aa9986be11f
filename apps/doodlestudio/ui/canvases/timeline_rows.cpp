#include "doodlestudio/ui/canvases/timeline_rows.h"

#include "doodling/canvas/doodle_time.h"

#include <algorithm>

namespace ductus {

namespace {

QList<TimelineDrawing> drawingsOf(const Canvas &canvas, int frameCount)
{
    QList<TimelineDrawing> drawings;
    // A single drawing that is there all the time has nothing to tell.
    if (canvas.doodle.frames.size() < 2)
        return drawings;
    const int cycle = cycleLength(canvas.doodle);
    for (int frame = 0; frame < frameCount; ++frame) {
        const std::optional<int> index =
            isShownIn(canvas, frame) ? doodleFrameAt(canvas.doodle, frame) : std::nullopt;
        if (!index)
            continue;
        const bool isRepeat = frame < canvas.doodle.offset || frame >= canvas.doodle.offset + cycle;
        if (!drawings.isEmpty() && drawings.back().index == *index && drawings.back().last == frame - 1) {
            drawings.back().last = frame;
            continue;
        }
        drawings << TimelineDrawing{*index, frame, frame,
                                    canvas.doodle.frames[std::size_t(*index)].marks.empty(), isRepeat};
    }
    return drawings;
}

} // namespace

KeyframeKind keyframeKind(TimelineMarkKind kind)
{
    switch (kind) {
    case TimelineMarkKind::Depth:
        return KeyframeKind::Depth;
    case TimelineMarkKind::Turn:
        return KeyframeKind::Turn;
    case TimelineMarkKind::Size:
        return KeyframeKind::Scale;
    case TimelineMarkKind::Position:
        break;
    }
    return KeyframeKind::Position;
}

QList<TimelineRow> timelineRows(const StudioState &state)
{
    QList<TimelineRow> rows;
    const auto &canvases = state.document().scene().canvases;
    const std::shared_ptr<const Shot> shot = state.document().sceneShot();
    for (auto it = canvases.rbegin(); it != canvases.rend(); ++it) {
        const Canvas &canvas = *it;
        TimelineRow row;
        row.id = canvas.id.value;
        row.name = QString::fromStdString(canvas.name);
        row.colour = canvasColour(canvas.id);
        row.follows = canvas.motion == CanvasMotion::Dynamic;
        row.isVisible = canvas.isVisible;
        row.isChosen = canvas.id == state.chosen();
        for (const CanvasKeyframe &key : canvas.keyframes.positions)
            row.marks << TimelineMark{TimelineMarkKind::Position, key.frame, key.interpolatesNext};
        for (const DepthKeyframe &key : canvas.keyframes.depths)
            row.marks << TimelineMark{TimelineMarkKind::Depth, key.frame, false};
        for (const TurnKeyframe &key : canvas.keyframes.turns)
            row.marks << TimelineMark{TimelineMarkKind::Turn, key.frame, key.interpolatesNext};
        if (canvas.keyframes.scales.size() > 1)
            for (const ScaleKeyframe &key : canvas.keyframes.scales)
                row.marks << TimelineMark{TimelineMarkKind::Size, key.frame, false};
        row.drawings = drawingsOf(canvas, shot->frameCount());
        if (const auto track = const_cast<StudioState &>(state).follower().track(canvas.id);
            track && track->frames.size() == shot->cameras.size()) {
            for (std::size_t t = 0; t < track->frames.size(); ++t) {
                row.facing.push_back(float(CanvasView(shot->cameras[t], track->frames[t]).facing()));
                row.hidden.push_back(!track->frames[t].isVisible || !isShownIn(canvas, int(t)));
            }
        }
        rows << row;
    }
    return rows;
}

} // namespace ductus
