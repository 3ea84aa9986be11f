// RoleBrush: gives a role to every stroke the brush passes over. One drag is one step of the history.
#pragma once

#include "sketchsurfacer/ui/viewport/view_tool.h"

#include <functional>

namespace ductus {

class RoleBrush : public ViewTool
{
public:
    /// \a touched gets the index of a stroke's line and a number that is new for each drag.
    explicit RoleBrush(std::function<void(int line, quint64 drag)> touched) : mTouched(std::move(touched)) {}

    void setColour(const QColor &colour) { mColour = colour; }
    /// Pixels.
    void setRadius(double radius) { mRadius = radius; }
    double radius() const { return mRadius; }

    bool press(const ViewPointer &pointer, SketchView &view) override;
    void drag(const ViewPointer &pointer, SketchView &view) override;
    void hover(const ViewPointer &pointer, SketchView &view) override;
    bool cancel(SketchView &view) override;
    void paint(QPainter &painter, const SketchView &view) const override;
    QCursor cursor() const override { return Qt::CrossCursor; }

private:
    std::function<void(int, quint64)> mTouched;
    QColor mColour = Qt::white;
    double mRadius = 12.0;
    QPointF mPosition;
    bool mIsInside = false;
    quint64 mDrag = 0;
};

} // namespace ductus
