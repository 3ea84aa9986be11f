// Mouse and wheel in the canvas: what turns, pans and zooms the view, and what goes to the tool.
#include "sketchsurfacer/ui/viewport/sketch_view.h"

#include <QMouseEvent>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double clickReach = 4.0;   // pixels a hand trembles
constexpr double dividerReach = 8.0; // pixels around the divider that grab it

} // namespace

void SketchView::mousePressEvent(QMouseEvent *event)
{
    setFocus(Qt::MouseFocusReason);
    mFlight.stop(); // the hand goes before
    if (mDrag != Drag::None)
        return;
    mPressed = mLast = event->position();
    mHasMoved = false;
    const bool wantsView = event->modifiers() & Qt::AltModifier;
    if (event->button() == Qt::MiddleButton ||
        (event->button() == Qt::LeftButton && wantsView && (event->modifiers() & Qt::ShiftModifier)))
        mDrag = Drag::Pan;
    else if (event->button() == Qt::RightButton || (event->button() == Qt::LeftButton && wantsView))
        mDrag = Drag::Orbit;
    else if (event->button() == Qt::LeftButton && mDivider && mMode != ViewMode::Sketch &&
             std::abs(event->position().x() - *mDivider * width()) < dividerReach)
        mDrag = Drag::Divider;
    else if (event->button() == Qt::LeftButton)
        mDrag =
            mTool && mTool->press({event->position(), event->modifiers()}, *this) ? Drag::Tool : Drag::Orbit;
    if (mDrag == Drag::Orbit)
        if (const std::optional<RayHit> hit = surfaceAt(event->position()))
            mCamera.setTarget(hit->point); // what one grabs stays under the hand
    mOverlay->update();
    event->accept();
}

void SketchView::mouseMoveEvent(QMouseEvent *event)
{
    const QPointF by = event->position() - mLast;
    const QPointF all = event->position() - mPressed;
    const ViewPointer pointer{event->position(), event->modifiers()};
    mHasMoved = mHasMoved || std::hypot(all.x(), all.y()) > clickReach;
    switch (mDrag) {
    case Drag::None:
        if (mDivider && mMode != ViewMode::Sketch)
            setCursor(std::abs(event->position().x() - *mDivider * width()) < dividerReach
                          ? QCursor(Qt::SplitHCursor)
                      : mTool ? mTool->cursor()
                              : QCursor(Qt::ArrowCursor));
        if (mTool)
            mTool->hover(pointer, *this);
        mOverlay->update();
        break;
    case Drag::Tool:
        mTool->drag(pointer, *this);
        mOverlay->update();
        break;
    case Drag::Orbit:
        if (!mHasMoved)
            return; // a click must not turn the view by a pixel
        mCamera.orbit(by);
        moved();
        break;
    case Drag::Pan:
        mCamera.pan(by);
        moved();
        break;
    case Drag::Divider:
        mDivider = std::clamp(event->position().x() / std::max(1, width()), 0.02, 0.98);
        emit comparisonMoved(*mDivider);
        moved();
        break;
    }
    mLast = event->position();
}

void SketchView::mouseReleaseEvent(QMouseEvent *event)
{
    const ViewPointer pointer{event->position(), event->modifiers()};
    const Drag drag = std::exchange(mDrag, Drag::None);
    if (drag == Drag::Tool && event->button() == Qt::LeftButton)
        mTool->release(pointer, *this);
    else if (drag == Drag::Orbit && event->button() == Qt::LeftButton && !mHasMoved && mTool)
        mTool->click(pointer, *this);
    mOverlay->update();
    event->accept();
}

void SketchView::wheelEvent(QWheelEvent *event)
{
    const double steps = event->angleDelta().y() / 120.0;
    if (steps != 0.0 && mTool && mTool->wheel(steps, *this)) {
        mOverlay->update();
    } else if (steps != 0.0) {
        mCamera.zoom(std::pow(0.86, steps), event->position());
        moved();
    }
    event->accept();
}

void SketchView::leaveEvent(QEvent *event)
{
    if (mTool && mDrag == Drag::None)
        mTool->cancel(*this);
    mOverlay->update();
    VtkWidget::leaveEvent(event);
}

} // namespace ductus
