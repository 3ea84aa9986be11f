#include "doodlestudio/ui/canvases/studio_state.h"

#include "doodling/canvas/doodle_time.h"

#include <algorithm>
#include <array>

namespace ductus {

QColor canvasColour(CanvasId id)
{
    // Far apart also for those who see red and green alike [Okabe, Ito 2008], lightened for video.
    static const std::array<QColor, 8> colours{QColor(0xff, 0x7d, 0x5c), QColor(0x56, 0xb4, 0xe9),
                                               QColor(0x2c, 0xc5, 0x93), QColor(0xf0, 0xd0, 0x42),
                                               QColor(0xcc, 0x79, 0xa7), QColor(0x5c, 0x8d, 0xff),
                                               QColor(0xe6, 0x9f, 0x00), QColor(0xb4, 0xb4, 0xb4)};
    return colours[std::size_t(std::max(0, id.value)) % colours.size()];
}

QPointF toPoint(const Vec2 &v)
{
    return {v.x(), v.y()};
}

Vec2 toVec(const QPointF &p)
{
    return {p.x(), p.y()};
}

StudioState::StudioState(DoodleDocument &document, CanvasFollower &follower, QObject *parent)
    : QObject(parent), mDocument(document), mFollower(follower)
{
    connect(&document, &Document::changed, this, &StudioState::onDocumentChanged);
    connect(&follower, &CanvasFollower::trackChanged, this, &StudioState::lookChanged);
}

void StudioState::onDocumentChanged(const ChangeEvent &event)
{
    if (event.as<DocumentReset>())
        choose({});
    else if (mChosen.isValid() && !chosenCanvas())
        choose({});
    emit lookChanged();
}

void StudioState::setFrame(int frame)
{
    if (frame == mFrame)
        return;
    mFrame = frame;
    emit frameChanged(frame);
}

void StudioState::choose(CanvasId id)
{
    if (id == mChosen)
        return;
    mChosen = id;
    emit chosenChanged();
    emit lookChanged();
}

std::optional<CanvasFrame> StudioState::place(const Canvas &canvas) const
{
    std::optional<CanvasFrame> place = mFollower.place(canvas.id, mFrame);
    const std::shared_ptr<const Shot> shot = mDocument.sceneShot();
    if (!place || mFrame >= shot->frameCount())
        return std::nullopt;
    if (mFollower.isUpToDate(canvas.id))
        return place;
    for (const TurnKeyframe &turn : canvas.keyframes.turns)
        if (turn.frame == mFrame)
            place->worldFromCanvas = turn.worldFromCanvas.normalized();
    for (const ScaleKeyframe &scale : canvas.keyframes.scales)
        if (scale.frame == mFrame)
            place->scale = scale.scale;
    for (const DepthKeyframe &depth : canvas.keyframes.depths)
        if (depth.frame == mFrame)
            place->depth = depth.depth;
    for (const CanvasKeyframe &position : canvas.keyframes.positions)
        if (position.frame == mFrame)
            place->pixel = position.pixel;
    place->position = shot->cameras[std::size_t(mFrame)].unprojected(place->pixel, place->depth);
    return place;
}

std::optional<CanvasView> StudioState::view(const Canvas &canvas) const
{
    const std::optional<CanvasFrame> where = place(canvas);
    if (!where)
        return std::nullopt;
    return CanvasView(mDocument.sceneShot()->cameras[std::size_t(mFrame)], *where);
}

std::optional<QTransform> StudioState::workingFromCanvas(const Canvas &canvas) const
{
    const std::optional<CanvasView> seen = view(canvas);
    if (!seen || seen->facing() < 0.01)
        return std::nullopt;
    for (const Vec2 &corner : {Vec2(-0.5, -0.5), Vec2(0.5, -0.5), Vec2(0.5, 0.5), Vec2(-0.5, 0.5)})
        if (seen->depthOf(corner.cwiseProduct(canvas.size)) <= 1e-6)
            return std::nullopt;
    const Eigen::Matrix3d &h = seen->pixelFromCanvas();
    // QTransform multiplies rows from the left: transposed.
    const QTransform pixels(h(0, 0), h(1, 0), h(2, 0), h(0, 1), h(1, 1), h(2, 1), h(0, 2), h(1, 2), h(2, 2));
    return QTransform::fromScale(1.0 / canvasGrain, 1.0 / canvasGrain) * pixels;
}

CanvasId StudioState::canvasAt(const Vec2 &working) const
{
    CanvasId found;
    double nearest = 1e300;
    for (const Canvas &canvas : mDocument.scene().canvases) {
        if (!isShownIn(canvas, mFrame))
            continue;
        const std::optional<CanvasView> seen = view(canvas);
        const std::optional<Vec2> on = seen ? seen->canvasPointOf(working) : std::nullopt;
        if (!on || std::abs(on->x()) > 0.5 * canvas.size.x() || std::abs(on->y()) > 0.5 * canvas.size.y())
            continue;
        const double depth = canvas.id == mChosen ? -1.0 : seen->depthOf(*on);
        if (depth <= nearest) {
            nearest = depth;
            found = canvas.id;
        }
    }
    return found;
}

int StudioState::drawingOf(const Canvas &canvas) const
{
    if (const std::optional<int> shown = doodleFrameAt(canvas.doodle, mFrame))
        return *shown;
    return mFrame < canvas.doodle.offset ? 0 : int(canvas.doodle.frames.size()) - 1;
}

void StudioState::goToDrawing(const Canvas &canvas, int index)
{
    if (drawingOf(canvas) == index)
        return;
    if (const std::optional<int> frame = nextShowing(canvas.doodle, index, mFrame);
        frame && *frame < mDocument.clip().frameCount) {
        requestFrame(*frame);
        return;
    }
    // Not again before the end: the last time it was shown.
    for (int frame = mFrame; frame >= 0; --frame) {
        if (doodleFrameAt(canvas.doodle, frame) == std::optional(index)) {
            requestFrame(frame);
            return;
        }
    }
}

void StudioState::setBrush(const Brush &brush)
{
    mBrush = brush;
    emit brushChanged();
}

void StudioState::setOnionSkin(const OnionSkin &onion)
{
    mOnion = onion;
    emit onionChanged();
    emit lookChanged();
}

} // namespace ductus
