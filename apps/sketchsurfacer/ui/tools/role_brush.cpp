#include "sketchsurfacer/ui/tools/role_brush.h"

#include "document/commands/change_value.h"
#include "sketchsurfacer/ui/viewport/sketch_view.h"

namespace ductus {

bool RoleBrush::press(const ViewPointer &pointer, SketchView &view)
{
    mDrag = nextDrag();
    drag(pointer, view);
    return true;
}

void RoleBrush::drag(const ViewPointer &pointer, SketchView &view)
{
    mPosition = pointer.position;
    mIsInside = true;
    if (const int line = view.strokeAt(pointer.position, mRadius); line >= 0)
        mTouched(line, mDrag);
}

void RoleBrush::hover(const ViewPointer &pointer, SketchView &)
{
    mPosition = pointer.position;
    mIsInside = true;
}

bool RoleBrush::cancel(SketchView &)
{
    mIsInside = false;
    return false;
}

void RoleBrush::paint(QPainter &painter, const SketchView &) const
{
    if (!mIsInside)
        return;
    painter.setBrush(QColor(mColour.red(), mColour.green(), mColour.blue(), 46));
    painter.setPen(QPen(mColour, 2.0));
    painter.drawEllipse(mPosition, mRadius, mRadius);
}

} // namespace ductus
