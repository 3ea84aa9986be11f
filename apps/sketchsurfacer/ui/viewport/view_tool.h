// ViewTool: what the left button means in the viewport. The view turns, pans and zooms by itself; a tool
// takes the drags it wants and leaves the others to the view.
#pragma once

#include <QCursor>
#include <QPainter>
#include <QPointF>
#include <Qt>

namespace ductus {

class SketchView;

struct ViewPointer
{
    QPointF position; // logical pixels
    Qt::KeyboardModifiers modifiers;
};

class ViewTool
{
public:
    virtual ~ViewTool() = default;

    /// The left button went down. True: the tool takes the drag; false: it turns the view.
    virtual bool press(const ViewPointer &, SketchView &) { return false; }
    /// Of a drag that was taken.
    virtual void drag(const ViewPointer &, SketchView &) {}
    virtual void release(const ViewPointer &, SketchView &) {}
    /// Pressed and released in one place, of a press that was not taken.
    virtual void click(const ViewPointer &, SketchView &) {}
    /// Moved without a button.
    virtual void hover(const ViewPointer &, SketchView &) {}
    /// The wheel was turned by so many notches; false: it zooms.
    virtual bool wheel(double, SketchView &) { return false; }
    /// The pointer left, the tool was put away, or Esc: forget what was begun. True if there was something.
    virtual bool cancel(SketchView &) { return false; }
    /// What the tool shows above the scene: a brush ring, the line being drawn.
    virtual void paint(QPainter &, const SketchView &) const {}
    virtual QCursor cursor() const { return Qt::ArrowCursor; }
};

} // namespace ductus
