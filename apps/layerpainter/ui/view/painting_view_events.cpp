// What mouse, pen and wheel do on the canvas.
#include "layerpainter/ui/view/painting_view.h"

#include <QMouseEvent>
#include <QTabletEvent>
#include <QWheelEvent>
#include <cmath>

namespace ductus {

void PaintingView::mousePressEvent(QMouseEvent *event)
{
    mLast = event->position();
    const bool turns = event->button() == Qt::RightButton || (event->modifiers() & Qt::AltModifier) || !mTool;
    if (event->button() == Qt::MiddleButton || (turns && (event->modifiers() & Qt::ShiftModifier)))
        mDrag = Drag::Pan;
    else if (turns)
        mDrag = Drag::Orbit;
    else
        mDrag = Drag::Tool;
    if (mDrag == Drag::Tool)
        mTool->press(*this, {event->position(), 1, event->modifiers()});
    else if (const auto picked = pick(event->position()))
        mCamera.setPivotDepth(picked->position);
    updateMarks();
}

void PaintingView::mouseMoveEvent(QMouseEvent *event)
{
    const QPointF by = event->position() - mLast;
    mLast = event->position();
    if (mDrag == Drag::Orbit)
        mCamera.orbit(by);
    else if (mDrag == Drag::Pan)
        mCamera.pan(by);
    if (mDrag == Drag::Orbit || mDrag == Drag::Pan) {
        movedView();
        emit viewMoved();
    } else if (mTool)
        mTool->move(*this, {event->position(), 1, event->modifiers()});
    updateMarks();
    if (mDrag == Drag::None)
        emit pointerMoved(event->position());
}

void PaintingView::mouseReleaseEvent(QMouseEvent *event)
{
    if (mDrag == Drag::Tool && mTool)
        mTool->release(*this, {event->position(), 1, event->modifiers()});
    mDrag = Drag::None;
    updateMarks();
}

void PaintingView::tabletEvent(QTabletEvent *event)
{
    const bool isPainting = mTool && !(event->modifiers() & Qt::AltModifier);
    if (!isPainting || event->button() == Qt::RightButton || event->button() == Qt::MiddleButton) {
        event->ignore(); // comes again as a mouse event
        return;
    }
    const double pressure = mPressure ? mPressure(event->pressure()) : event->pressure();
    const CanvasPointer pointer{event->position(), pressure, event->modifiers(),
                                event->pointerType() == QPointingDevice::PointerType::Eraser};
    event->accept();
    mLast = event->position();
    if (event->type() == QEvent::TabletPress) {
        mDrag = Drag::Tool;
        mTool->press(*this, pointer);
    } else if (event->type() == QEvent::TabletMove) {
        mTool->move(*this, pointer);
    } else if (event->type() == QEvent::TabletRelease && mDrag == Drag::Tool) {
        mTool->release(*this, pointer);
        mDrag = Drag::None;
    }
    updateMarks();
}

void PaintingView::wheelEvent(QWheelEvent *event)
{
    mCamera.zoom(std::pow(0.9988, event->angleDelta().y()), event->position());
    movedView();
    emit viewMoved();
}

void PaintingView::leaveEvent(QEvent *)
{
    mLast = QPointF(-1000, -1000);
    updateMarks();
}

} // namespace ductus
