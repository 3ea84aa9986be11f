// What stands between the player's picture and the hand: layers that draw on it and tools that also listen.
#pragma once

#include <QCursor>
#include <QPainter>
#include <QPointF>
#include <Qt>

namespace ductus {

class PlayerView;

/// The mouse or the pen, where and how.
struct PointerState
{
    QPointF inView;
    QPointF working; // pixels of the working copy
    double pressure = 1.0;
    Qt::KeyboardModifiers modifiers;
    bool isEraser = false; // the pen's other end
    bool isPen = false;
};

class PlayerLayer
{
public:
    virtual ~PlayerLayer() = default;
    /// In widget pixels.
    virtual void paint(QPainter &painter, const PlayerView &view) = 0;
};

class PlayerTool
{
public:
    virtual ~PlayerTool() = default;
    /// Over everything else.
    virtual void paint(QPainter &, const PlayerView &) {}
    virtual void press(const PointerState &pointer, PlayerView &view) = 0;
    virtual void drag(const PointerState &pointer, PlayerView &view) = 0;
    virtual void release(const PointerState &pointer, PlayerView &view) = 0;
    /// The drag is given up: as if it had not been.
    virtual void cancel(PlayerView &) {}
    virtual void hover(const PointerState &, PlayerView &) {}
    virtual void leave(PlayerView &) {}
};

} // namespace ductus
