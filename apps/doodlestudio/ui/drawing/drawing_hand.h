// DrawingHand: what the pen does on a canvas, whether it is drawn on in the panel or straight on the picture:
// places come in canvas units, finished marks go into the document.
#pragma once

#include "document/settings/pressure_curve.h"
#include "doodlestudio/ui/canvases/studio_state.h"

#include <QElapsedTimer>
#include <QPainter>

namespace ductus {

/// Where the pen is on the canvas.
struct HandPoint
{
    Vec2 onCanvas = Vec2::Zero();
    double pressure = 1.0;
    bool isEraser = false; // the pen's other end
};

class DrawingHand : public QObject
{
    Q_OBJECT
public:
    explicit DrawingHand(StudioState &state, QObject *parent = nullptr);

    void setPressureCurve(const PressureCurve &curve) { mCurve = curve; }

    /// On the chosen canvas' present drawing; false if there is none to draw on.
    bool press(const HandPoint &point);
    void move(const HandPoint &point);
    void release(const HandPoint &point);
    /// What was begun is forgotten.
    void cancel();
    bool isDrawing() const { return mIsDrawing; }
    bool isErasing() const;

    /// What is being drawn; \a painter in canvas units times canvasGrain.
    void paint(QPainter &painter) const;
    /// The mark that was finished last and is perhaps not in the composited picture yet.
    const MarkPointer &lastMark() const { return mLastMark; }
    void forgetLastMark() { mLastMark = nullptr; }
    /// Radius of the brush or eraser, canvas units.
    double radius() const;

signals:
    void changed();
    /// Words are to be typed for this place of the canvas.
    void textWanted(const ductus::Vec2 &place);

private:
    DrawingTool tool() const;
    void add(const HandPoint &point);
    std::optional<DoodleMark> unfinished() const;
    void finish(DoodleMark mark, const QString &text);

    StudioState &mState;
    PressureCurve mCurve;
    bool mIsDrawing = false;
    bool mIsEraserEnd = false;
    CanvasId mCanvas;
    int mDrawing = 0;
    quint64 mDrag = 0;
    Doodle mBefore;
    std::vector<Vec2> mPoints;
    std::vector<double> mPressures;
    std::vector<double> mTimes;
    QElapsedTimer mClock;
    MarkPointer mMoved;
    MarkPointer mLastMark;
};

} // namespace ductus
