#include "doodlestudio/ui/canvases/occlusion_tool.h"

#include "doodlestudio/ui/player/player_view.h"

#include <QCoreApplication>
#include <algorithm>

namespace ductus {

namespace {

constexpr double brushShare = 0.035; // of the picture's height

} // namespace

double OcclusionTool::radius() const
{
    return std::max(4.0, brushShare * mState.document().sceneShot()->height);
}

void OcclusionTool::press(const PointerState &pointer, PlayerView &view)
{
    mIsBrushing = mState.chosenCanvas() != nullptr;
    mLine = {toVec(pointer.working)};
    view.update();
}

void OcclusionTool::drag(const PointerState &pointer, PlayerView &view)
{
    mPointer = pointer.inView;
    const Vec2 here = toVec(pointer.working);
    if (mIsBrushing && (here - mLine.back()).norm() > 0.25 * radius())
        mLine.push_back(here);
    view.update();
}

void OcclusionTool::release(const PointerState &pointer, PlayerView &view)
{
    const Canvas *canvas = mState.chosenCanvas();
    if (mIsBrushing && canvas) {
        Canvas changed = *canvas;
        OcclusionTouch touch;
        touch.frame = mState.frame();
        touch.line = mLine;
        touch.radius = radius();
        touch.isCanvasInFront = mIsInFront;
        changed.occlusion.touches.push_back(std::move(touch));
        mState.document().editCanvas(mIsInFront
                                         ? QCoreApplication::translate("OcclusionTool", "Bring in front")
                                         : QCoreApplication::translate("OcclusionTool", "Put behind"),
                                     std::move(changed));
    }
    cancel(view);
}

void OcclusionTool::cancel(PlayerView &view)
{
    mIsBrushing = false;
    mLine.clear();
    view.update();
}

void OcclusionTool::hover(const PointerState &pointer, PlayerView &view)
{
    mPointer = pointer.inView;
    view.setCursor(Qt::BlankCursor);
    view.update();
}

void OcclusionTool::leave(PlayerView &view)
{
    mPointer.reset();
    view.unsetCursor();
}

void OcclusionTool::paint(QPainter &painter, const PlayerView &view)
{
    const double radiusInView = radius() * view.zoom();
    const QColor colour = mIsInFront ? QColor(0x3f, 0xc5, 0x80) : QColor(0xe0, 0x70, 0xf0);
    QColor veil = colour;
    veil.setAlpha(110);
    if (mIsBrushing) {
        QPolygonF line;
        for (const Vec2 &point : mLine)
            line << view.toView(toPoint(point));
        painter.setPen(QPen(veil, 2 * radiusInView, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        line.size() > 1 ? painter.drawPolyline(line) : painter.drawPoint(line.first());
    }
    if (mPointer) {
        painter.setPen(QPen(colour, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(*mPointer, radiusInView, radiusInView);
    }
}

} // namespace ductus
