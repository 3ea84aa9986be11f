#include "doodlestudio/ui/drawing/direct_draw_tool.h"

#include "doodlestudio/document/placing.h"
#include "doodlestudio/ui/player/player_view.h"
#include "doodling/canvas/edit_scene.h"

#include <QCoreApplication>

namespace ductus {

namespace {

constexpr double newCanvasShare = 0.7; // of the picture: a canvas made by drawing has room around it

} // namespace

std::optional<HandPoint> DirectDrawTool::handPoint(const PointerState &pointer) const
{
    const Canvas *canvas = mState.chosenCanvas();
    const std::optional<CanvasView> seen = canvas ? mState.view(*canvas) : std::nullopt;
    const std::optional<Vec2> place = seen ? seen->canvasPointOf(toVec(pointer.working)) : std::nullopt;
    if (!place)
        return std::nullopt;
    return HandPoint{*place, pointer.pressure, pointer.isEraser};
}

void DirectDrawTool::makeCanvas(const PointerState &pointer)
{
    const std::shared_ptr<const Shot> shot = mState.document().sceneShot();
    const Vec2 half = 0.5 * newCanvasShare * Vec2(shot->width, shot->height);
    const Vec2 at = toVec(pointer.working);
    int number = 1;
    for (const Canvas &canvas : mState.document().scene().canvases)
        number = std::max(number, canvas.id.value + 2);
    const QString name = QCoreApplication::translate("DirectDrawTool", "Canvas %1").arg(number);
    if (mState.document().edit(
            QCoreApplication::translate("DirectDrawTool", "Add canvas"),
            withCanvas(mState.document().scene(),
                       canvasInBox(*shot, mState.frame(), at - half, at + half, name.toStdString()))))
        mState.choose(mState.document().scene().canvases.back().id);
}

void DirectDrawTool::press(const PointerState &pointer, PlayerView &view)
{
    const CanvasId under = mState.canvasAt(toVec(pointer.working));
    if (under.isValid())
        mState.choose(under);
    else if (!view.pictureRect().contains(pointer.inView) || mState.brush().tool == DrawingTool::Eraser)
        return;
    else
        makeCanvas(pointer);
    if (const std::optional<HandPoint> point = handPoint(pointer))
        mHand.press(*point);
}

void DirectDrawTool::drag(const PointerState &pointer, PlayerView &view)
{
    mPointer = pointer.inView;
    if (const std::optional<HandPoint> point = handPoint(pointer))
        mHand.move(*point);
    view.update();
}

void DirectDrawTool::release(const PointerState &pointer, PlayerView &view)
{
    if (const std::optional<HandPoint> point = handPoint(pointer))
        mHand.release(*point);
    else
        mHand.cancel();
    view.update();
}

void DirectDrawTool::cancel(PlayerView &view)
{
    mHand.cancel();
    view.update();
}

void DirectDrawTool::hover(const PointerState &pointer, PlayerView &view)
{
    mPointer = pointer.inView;
    view.setCursor(Qt::CrossCursor);
    view.update();
}

void DirectDrawTool::leave(PlayerView &view)
{
    mPointer.reset();
    view.unsetCursor();
}

void DirectDrawTool::paint(QPainter &painter, const PlayerView &view)
{
    const Canvas *canvas = mState.chosenCanvas();
    const std::optional<QTransform> transform = canvas ? mState.workingFromCanvas(*canvas) : std::nullopt;
    if (!transform)
        return;
    painter.save();
    painter.setClipRect(view.pictureRect(), Qt::IntersectClip);
    painter.setTransform(*transform * view.viewFromWorking() * painter.transform());
    mHand.paint(painter);
    painter.restore();
}

} // namespace ductus
