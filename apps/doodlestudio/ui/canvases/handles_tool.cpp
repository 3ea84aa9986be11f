#include "doodlestudio/ui/canvases/handles_tool.h"

#include "document/commands/change_value.h"
#include "doodlestudio/document/placing.h"
#include "doodlestudio/ui/player/player_view.h"
#include "doodling/canvas/edit_scene.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double reach = 13.0; // widget pixels around a handle
constexpr double gaugeRadius = 26.0;
constexpr double spinDistance = 30.0;
constexpr double clickDistance = 4.0;

double distance(const QPointF &a, const QPointF &b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace

HandlesTool::HandlesTool(StudioState &state, QObject *parent) : QObject(parent), mState(state) {}

std::optional<HandlesTool::Handles> HandlesTool::handles(const PlayerView &view) const
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas || !isShownIn(*canvas, mState.frame()))
        return std::nullopt;
    const std::optional<CanvasFrame> place = mState.place(*canvas);
    const std::optional<CanvasView> seen = mState.view(*canvas);
    if (!place || !seen)
        return std::nullopt;
    Handles handles;
    for (const Vec2 &corner : {Vec2(-0.5, -0.5), Vec2(0.5, -0.5), Vec2(0.5, 0.5), Vec2(-0.5, 0.5)}) {
        const std::optional<Vec2> pixel = seen->pixelOf(corner.cwiseProduct(canvas->size));
        if (!pixel)
            return std::nullopt;
        handles.edge << view.toView(toPoint(*pixel));
    }
    handles.middle = view.toView(toPoint(place->pixel));
    handles.corner = handles.edge[2];
    handles.topMiddle = 0.5 * (handles.edge[0] + handles.edge[1]);
    const QPointF up = handles.topMiddle - handles.middle;
    const double length = std::max(1.0, std::hypot(up.x(), up.y()));
    handles.spin = handles.topMiddle + up / length * spinDistance;
    handles.gauge = handles.edge[3] + QPointF(-gaugeRadius - 12.0, gaugeRadius * 0.4);
    // In sight, whatever the canvas covers.
    const QRectF room =
        QRectF(view.rect()).adjusted(gaugeRadius + 4, gaugeRadius + 4, -gaugeRadius - 4, -gaugeRadius - 4);
    handles.gauge = {std::clamp(handles.gauge.x(), room.left(), std::max(room.left(), room.right())),
                     std::clamp(handles.gauge.y(), room.top(), std::max(room.top(), room.bottom()))};
    handles.front = frontInCamera(place->worldFromCanvas,
                                  mState.document().sceneShot()->cameras[std::size_t(mState.frame())]);
    return handles;
}

HandlesTool::Part HandlesTool::partAt(const QPointF &inView, const PlayerView &view) const
{
    if (const std::optional<Handles> at = handles(view)) {
        if (distance(inView, at->gauge) <= gaugeRadius + 3.0)
            return Part::Gauge;
        if (distance(inView, at->corner) <= reach)
            return Part::Corner;
        if (distance(inView, at->spin) <= reach)
            return Part::Spin;
        if (distance(inView, at->middle) <= reach)
            return Part::Middle;
        if (const Canvas *canvas = mState.chosenCanvas()) {
            if (trajectoryOf(mState, *canvas, view).frameNear(inView, reach * 0.8))
                return Part::Path;
        }
        if (at->edge.containsPoint(inView, Qt::OddEvenFill))
            return Part::Middle;
    } else if (const Canvas *canvas = mState.chosenCanvas()) {
        if (trajectoryOf(mState, *canvas, view).frameNear(inView, reach * 0.8))
            return Part::Path;
    }
    if (mState.canvasAt(toVec(view.toWorking(inView))).isValid())
        return Part::Other;
    return Part::Empty;
}

QString HandlesTool::sentence(Part part) const
{
    const Canvas *canvas = mState.chosenCanvas();
    switch (part) {
    case Part::Middle:
        return canvas && canvas->motion == CanvasMotion::Dynamic
                   ? tr("Drag the canvas where it must be in this frame: it is pinned there.")
                   : tr("Drag the canvas where it should stand.");
    case Part::Corner:
        return tr("Drag to make the canvas larger or smaller.");
    case Part::Spin:
        return tr("Drag to turn the canvas in its plane.");
    case Part::Gauge:
        return tr("Drag the pin of the gauge: the canvas looks where the pin points.");
    case Part::Path:
        return tr("Click to go to this moment, drag to pin the canvas elsewhere then.");
    case Part::Other:
        return tr("Click to choose this canvas.");
    case Part::Empty:
        return mAdds ? tr("Drag out a box: a canvas will stand there in the scene.") : QString();
    case Part::None:
        break;
    }
    return {};
}

void HandlesTool::hover(const PointerState &pointer, PlayerView &view)
{
    const Part part = partAt(pointer.inView, view);
    const Canvas *canvas = mState.chosenCanvas();
    mHoveredFrame = part == Part::Path && canvas
                        ? trajectoryOf(mState, *canvas, view).frameNear(pointer.inView, reach * 0.8)
                        : std::nullopt;
    if (part != mHovered) {
        mHovered = part;
        switch (part) {
        case Part::Middle:
            view.setCursor(Qt::SizeAllCursor);
            break;
        case Part::Corner:
            view.setCursor(Qt::SizeFDiagCursor);
            break;
        case Part::Spin:
        case Part::Gauge:
            view.setCursor(Qt::OpenHandCursor);
            break;
        case Part::Path:
        case Part::Other:
            view.setCursor(Qt::PointingHandCursor);
            break;
        default:
            view.setCursor(mAdds ? Qt::CrossCursor : Qt::ArrowCursor);
        }
        emit hinted(sentence(part));
    }
    view.update();
}

void HandlesTool::leave(PlayerView &view)
{
    mHovered = Part::None;
    mHoveredFrame.reset();
    view.unsetCursor();
    emit hinted({});
}

void HandlesTool::press(const PointerState &pointer, PlayerView &view)
{
    mPart = partAt(pointer.inView, view);
    mPressed = mNow = pointer;
    mDrag = nextDrag();
    mStepsBefore = mState.document().undoStack()->index();
    if (mPart == Part::Other) {
        mState.choose(mState.canvasAt(toVec(pointer.working)));
        mPart = Part::Middle;
    } else if (mPart == Part::Path) {
        if (const std::optional<int> frame =
                trajectoryOf(mState, *mState.chosenCanvas(), view).frameNear(pointer.inView, reach * 0.8))
            mState.requestFrame(*frame);
        mPart = Part::Middle;
    } else if (mPart == Part::Empty && !mAdds) {
        mState.choose({});
    }
    if (const Canvas *canvas = mState.chosenCanvas()) {
        mSizeBefore = canvas->size;
        if (const std::optional<CanvasFrame> place = mState.place(*canvas)) {
            mPlaceBefore = *place;
            mGrip = toPoint(place->pixel) - pointer.working;
        }
    }
    view.update();
}

void HandlesTool::drag(const PointerState &pointer, PlayerView &view)
{
    mNow = pointer;
    if (distance(pointer.inView, mPressed.inView) < clickDistance &&
        mState.document().undoStack()->index() == mStepsBefore) {
        return; // still a click
    }
    switch (mPart) {
    case Part::Middle:
        moveTo(pointer);
        break;
    case Part::Corner:
        resizeTo(pointer, view);
        break;
    case Part::Spin:
        spinTo(pointer, view);
        break;
    case Part::Gauge:
        tiltTo(pointer);
        break;
    default:
        break;
    }
    view.update();
}

void HandlesTool::release(const PointerState &pointer, PlayerView &view)
{
    mNow = pointer;
    if (mPart == Part::Empty && mAdds)
        addCanvas(pointer);
    mPart = Part::None;
    view.update();
}

void HandlesTool::cancel(PlayerView &view)
{
    mPart = Part::None;
    if (mState.document().undoStack()->index() > mStepsBefore)
        mState.document().undoStack()->undo();
    view.update();
}

void HandlesTool::moveTo(const PointerState &pointer)
{
    if (const Canvas *canvas = mState.chosenCanvas()) {
        const QString text = canvas->motion == CanvasMotion::Dynamic ? tr("Pin canvas") : tr("Move canvas");
        mState.document().editCanvas(
            text, withMiddleAt(*canvas, mState.frame(), toVec(pointer.working + mGrip)), mDrag);
    }
}

void HandlesTool::resizeTo(const PointerState &pointer, const PlayerView &view)
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas)
        return;
    const QPointF middle = view.toView(toPoint(mPlaceBefore.pixel));
    const double before = distance(mPressed.inView, middle);
    const double factor = std::clamp(distance(pointer.inView, middle) / std::max(4.0, before), 0.05, 40.0);
    if (canvas->motion == CanvasMotion::Dynamic && !canvas->keyframes.scales.empty()) {
        mState.document().editCanvas(
            tr("Size canvas"), withScaleAt(*canvas, mState.frame(), mPlaceBefore.scale * factor), mDrag);
        return;
    }
    Canvas changed = *canvas;
    changed.keyframes.scales = {{canvas->keyframes.positions.front().frame, mPlaceBefore.scale * factor}};
    mState.document().editCanvas(tr("Size canvas"), std::move(changed), mDrag);
}

void HandlesTool::spinTo(const PointerState &pointer, const PlayerView &view)
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas)
        return;
    const QPointF middle = view.toView(toPoint(mPlaceBefore.pixel));
    const QPointF from = mPressed.inView - middle, to = pointer.inView - middle;
    double angle = std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x());
    if (pointer.modifiers & Qt::ShiftModifier) {
        constexpr double step = 3.14159265358979323846 / 12.0;
        angle = std::round(angle / step) * step;
    }
    mState.document().editCanvas(
        tr("Turn canvas"), withTurnAt(*canvas, mState.frame(), spun(mPlaceBefore.worldFromCanvas, angle)),
        mDrag);
}

void HandlesTool::tiltTo(const PointerState &pointer)
{
    const Canvas *canvas = mState.chosenCanvas();
    const std::shared_ptr<const Shot> shot = mState.document().sceneShot();
    if (!canvas || mState.frame() >= shot->frameCount())
        return;
    const ShotCamera &camera = shot->cameras[std::size_t(mState.frame())];
    const Vec3 before = frontInCamera(mPlaceBefore.worldFromCanvas, camera);
    const QPointF moved = (pointer.inView - mPressed.inView) / gaugeRadius;
    Vec2 along(before.x() + moved.x(), before.y() + moved.y());
    // Nearly from the edge is the most: beyond it would show its back.
    constexpr double most = 0.985;
    if (along.norm() > most)
        along *= most / along.norm();
    const Vec3 front(along.x(), along.y(), -std::sqrt(1.0 - along.squaredNorm()));
    mState.document().editCanvas(
        tr("Tilt canvas"),
        withTurnAt(*canvas, mState.frame(), tilted(mPlaceBefore.worldFromCanvas, camera, front)), mDrag);
}

void HandlesTool::addCanvas(const PointerState &pointer)
{
    const std::shared_ptr<const Shot> shot = mState.document().sceneShot();
    const auto inside = [&](const QPointF &p) {
        return Vec2(std::clamp(p.x(), 0.0, double(shot->width)),
                    std::clamp(p.y(), 0.0, double(shot->height)));
    };
    int number = 1;
    for (const Canvas &canvas : mState.document().scene().canvases)
        number = std::max(number, canvas.id.value + 2);
    Canvas canvas = canvasInBox(*shot, mState.frame(), inside(mPressed.working), inside(pointer.working),
                                tr("Canvas %1").arg(number).toStdString());
    if (!mState.document().edit(tr("Add canvas"), withCanvas(mState.document().scene(), std::move(canvas))))
        return;
    const CanvasId id = mState.document().scene().canvases.back().id;
    mState.choose(id);
    emit canvasAdded(id);
}

void HandlesTool::paint(QPainter &painter, const PlayerView &view)
{
    if (mPart == Part::Empty && mAdds && distance(mNow.inView, mPressed.inView) >= clickDistance) {
        painter.setPen(QPen(QColor(0xff, 0xff, 0xff), 1.5, Qt::DashLine));
        painter.setBrush(QColor(0xff, 0x7d, 0x5c, 50));
        painter.drawRect(QRectF(mPressed.inView, mNow.inView).normalized());
        return;
    }
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas)
        return;
    paintTrajectory(painter, trajectoryOf(mState, *canvas, view), *canvas, mState.frame(), mHoveredFrame);
    const std::optional<Handles> at = handles(view);
    if (!at)
        return;
    const QColor colour = canvasColour(canvas->id);
    const auto knob = [&](const QPointF &middle, Part part) {
        const bool isHot = mPart == part || (mPart == Part::None && mHovered == part);
        painter.setPen(QPen(QColor(0, 0, 0, 160), 1.5));
        painter.setBrush(isHot ? QColor(Qt::white) : colour);
        painter.drawEllipse(middle, isHot ? 8.0 : 6.5, isHot ? 8.0 : 6.5);
    };
    painter.setPen(QPen(QColor(0, 0, 0, 140), 3.5));
    painter.drawLine(at->topMiddle, at->spin);
    painter.setPen(QPen(colour, 1.5));
    painter.drawLine(at->topMiddle, at->spin);
    knob(at->spin, Part::Spin);
    knob(at->corner, Part::Corner);
    // The cross.
    for (const auto &[pen, width] :
         {std::pair(QColor(0, 0, 0, 170), 5.0), std::pair(QColor(0x5c, 0xe0, 0x8a), 2.5)}) {
        painter.setPen(QPen(pen, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(at->middle - QPointF(11, 0), at->middle + QPointF(11, 0));
        painter.drawLine(at->middle - QPointF(0, 11), at->middle + QPointF(0, 11));
    }
    // The gauge figure: a ball with a pin along the canvas' front.
    const bool isHot = mPart == Part::Gauge || (mPart == Part::None && mHovered == Part::Gauge);
    painter.setPen(QPen(isHot ? QColor(Qt::white) : colour, 1.6));
    painter.setBrush(QColor(0, 0, 0, 130));
    painter.drawEllipse(at->gauge, gaugeRadius, gaugeRadius);
    const QPointF pin = at->gauge + QPointF(at->front.x(), at->front.y()) * gaugeRadius;
    painter.save();
    painter.translate(at->gauge);
    painter.rotate(std::atan2(at->front.y(), at->front.x()) * 180.0 / 3.14159265358979323846);
    painter.setBrush(QColor(255, 255, 255, 60));
    const double thin = std::abs(at->front.z());
    painter.drawEllipse(QPointF(0, 0), gaugeRadius * 0.62 * thin, gaugeRadius * 0.62);
    painter.restore();
    painter.setPen(QPen(QColor(0xff, 0x5c, 0x5c), 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(at->gauge, pin);
    painter.setBrush(QColor(0xff, 0x5c, 0x5c));
    painter.drawEllipse(pin, 3.5, 3.5);
}

} // namespace ductus
