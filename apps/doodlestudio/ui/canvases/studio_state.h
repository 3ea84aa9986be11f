// StudioState: what the parts of the window share: the present frame, the chosen canvas, the pen. No content:
// that is the document's.
#pragma once

#include "doodlestudio/document/canvas_follower.h"
#include "doodling/canvas/canvas_view.h"

#include <QColor>
#include <QObject>
#include <QTransform>
#include <optional>

namespace ductus {

enum class DrawingTool { Pen, Fill, Arrow, Text, Sticker, Eraser, Move };

struct Brush
{
    DrawingTool tool = DrawingTool::Pen;
    QColor colour = QColor(0xff, 0xff, 0xff);
    double width = 0.022; // share of the canvas' longer side
    QString text;
    QString sticker;
};

struct OnionSkin
{
    bool isOn = false;
    int count = 2; // drawings before and after
};

class StudioState : public QObject
{
    Q_OBJECT
public:
    StudioState(DoodleDocument &document, CanvasFollower &follower, QObject *parent = nullptr);

    DoodleDocument &document() { return mDocument; }
    const DoodleDocument &document() const { return mDocument; }
    CanvasFollower &follower() { return mFollower; }

    int frame() const { return mFrame; }
    void setFrame(int frame);
    /// Asks the player to go there.
    void requestFrame(int frame) { emit frameRequested(frame); }

    CanvasId chosen() const { return mChosen; }
    const Canvas *chosenCanvas() const { return mDocument.canvas(mChosen); }
    void choose(CanvasId id);

    /// Where \a canvas is in the present frame: keyframes of this frame count at once, before the following
    /// is done. Nothing before the first following.
    std::optional<CanvasFrame> place(const Canvas &canvas) const;
    std::optional<CanvasView> view(const Canvas &canvas) const;
    /// From canvas units times canvasGrain to working pixels; nothing if part of the sheet is behind the
    /// camera or it is seen from its edge.
    std::optional<QTransform> workingFromCanvas(const Canvas &canvas) const;
    /// The topmost canvas shown under a place; invalid: none. The chosen one before others.
    CanvasId canvasAt(const Vec2 &working) const;

    /// The drawing of \a canvas that is drawn on now: the one shown in the present frame.
    int drawingOf(const Canvas &canvas) const;
    /// Goes to the frame nearest to the present one in which the drawing is shown.
    void goToDrawing(const Canvas &canvas, int index);

    const Brush &brush() const { return mBrush; }
    void setBrush(const Brush &brush);
    const OnionSkin &onionSkin() const { return mOnion; }
    void setOnionSkin(const OnionSkin &onion);

signals:
    void frameChanged(int frame);
    void frameRequested(int frame);
    void chosenChanged();
    void brushChanged();
    void onionChanged();
    /// Anything that is painted over the picture is another.
    void lookChanged();

private:
    void onDocumentChanged(const ChangeEvent &event);

    DoodleDocument &mDocument;
    CanvasFollower &mFollower;
    int mFrame = 0;
    CanvasId mChosen;
    Brush mBrush;
    OnionSkin mOnion;
};

/// Canvas units are small for Qt's strokers: it paints in thousandths.
inline constexpr double canvasGrain = 1000.0;

/// The colour a canvas has everywhere: handle, row, trajectory.
QColor canvasColour(CanvasId id);

QPointF toPoint(const Vec2 &v);
Vec2 toVec(const QPointF &p);

} // namespace ductus
