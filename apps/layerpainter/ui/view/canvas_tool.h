// CanvasTool: what the left button does on the canvas. The view itself turns, pans and zooms.
#pragma once

#include <QPointF>
#include <Qt>

class QPainter;

namespace ductus {

class PaintingView;

/// Mouse or pen: one kind of event for the tools.
struct CanvasPointer
{
    QPointF position; // logical pixels
    double pressure = 1;
    Qt::KeyboardModifiers modifiers;
    bool isEraser = false; // the other end of the pen
};

class CanvasTool
{
public:
    virtual ~CanvasTool() = default;

    virtual void press(PaintingView &view, const CanvasPointer &pointer) = 0;
    virtual void move(PaintingView &view, const CanvasPointer &pointer) = 0;
    virtual void release(PaintingView &view, const CanvasPointer &pointer) = 0;
    /// Esc: true if there was something to forget.
    virtual bool cancel(PaintingView &) { return false; }
    /// On top of the picture, in logical pixels.
    virtual void draw(PaintingView &, QPainter &) {}
    virtual Qt::CursorShape cursor() const { return Qt::CrossCursor; }
};

} // namespace ductus
