#include "doodlestudio/ui/drawing/drawing_hand.h"

#include "document/commands/change_value.h"
#include "doodlestudio/ui/canvases/mark_painter.h"
#include "doodling/canvas/edit_doodle.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double eraserFactor = 2.2; // as wide as the pen would be hard to hit with
constexpr double clickShare = 0.01;  // of the canvas: shorter is a click

double longerSide(const Canvas &canvas)
{
    return std::max(canvas.size.x(), canvas.size.y());
}

// The hand's tremble goes, corners stay: each point towards the middle of its neighbours, ends kept.
std::vector<Vec2> calmed(const std::vector<Vec2> &points)
{
    std::vector<Vec2> result = points;
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        result[i] = 0.25 * points[i - 1] + 0.5 * points[i] + 0.25 * points[i + 1];
    return result;
}

} // namespace

DrawingHand::DrawingHand(StudioState &state, QObject *parent) : QObject(parent), mState(state) {}

DrawingTool DrawingHand::tool() const
{
    return mIsEraserEnd ? DrawingTool::Eraser : mState.brush().tool;
}

bool DrawingHand::isErasing() const
{
    return tool() == DrawingTool::Eraser;
}

double DrawingHand::radius() const
{
    const Canvas *canvas = mState.chosenCanvas();
    const double width = canvas ? mState.brush().width * longerSide(*canvas) : 0.0;
    return 0.5 * width * (isErasing() ? eraserFactor : 1.0);
}

bool DrawingHand::press(const HandPoint &point)
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas || canvas->doodle.frames.empty())
        return false;
    mIsEraserEnd = point.isEraser;
    mCanvas = canvas->id;
    mDrawing = mState.drawingOf(*canvas);
    mBefore = canvas->doodle;
    mDrag = nextDrag();
    mPoints.clear();
    mPressures.clear();
    mTimes.clear();
    mMoved = nullptr;
    mClock.start();
    if (tool() == DrawingTool::Text) {
        emit textWanted(point.onCanvas);
        return true;
    }
    if (tool() == DrawingTool::Move)
        mMoved = markAt(mBefore.frames[std::size_t(mDrawing)], point.onCanvas, 0.02 * longerSide(*canvas));
    mIsDrawing = true;
    add(point);
    emit changed();
    return true;
}

void DrawingHand::add(const HandPoint &point)
{
    const Canvas *canvas = mState.document().canvas(mCanvas);
    if (!canvas)
        return;
    // Closer than a part of the line's width nothing is added to it.
    if (!mPoints.empty() && (point.onCanvas - mPoints.back()).norm() < 0.12 * radius())
        return;
    mPoints.push_back(point.onCanvas);
    mPressures.push_back(mCurve.map(std::clamp(point.pressure, 0.0, 1.0)));
    mTimes.push_back(double(mClock.nsecsElapsed()) * 1e-9);
}

void DrawingHand::move(const HandPoint &point)
{
    if (!mIsDrawing)
        return;
    add(point);
    if (tool() == DrawingTool::Eraser)
        mState.document().editDoodle(tr("Erase"), mCanvas, withErased(mBefore, mDrawing, mPoints, radius()),
                                     mDrag);
    else if (tool() == DrawingTool::Move && mMoved)
        mState.document().editDoodle(
            tr("Move drawing"), mCanvas,
            withChangedMark(mBefore, mDrawing, mMoved, movedMark(*mMoved, point.onCanvas - mPoints.front())),
            mDrag);
    emit changed();
}

void DrawingHand::release(const HandPoint &point)
{
    if (!mIsDrawing)
        return;
    add(point);
    mIsDrawing = false;
    if (tool() == DrawingTool::Eraser && mPoints.size() == 1) {
        mState.document().editDoodle(tr("Erase"), mCanvas, withErased(mBefore, mDrawing, mPoints, radius()),
                                     mDrag);
    } else if (std::optional<DoodleMark> mark = unfinished()) {
        const char *texts[] = {QT_TR_NOOP("Draw"), QT_TR_NOOP("Fill"), QT_TR_NOOP("Draw arrow"),
                               QT_TR_NOOP("Write"), QT_TR_NOOP("Add sticker")};
        finish(std::move(*mark), tr(texts[int(tool())]));
    }
    mIsEraserEnd = false;
    emit changed();
}

void DrawingHand::cancel()
{
    if (!mIsDrawing)
        return;
    const bool hasEdited = (isErasing() || mMoved) && mPoints.size() > 1;
    mIsDrawing = false;
    mIsEraserEnd = false;
    mPoints.clear();
    if (hasEdited)
        mState.document().undoStack()->undo();
    emit changed();
}

std::optional<DoodleMark> DrawingHand::unfinished() const
{
    const Canvas *canvas = mState.document().canvas(mCanvas);
    if (!canvas || mPoints.empty())
        return std::nullopt;
    const Brush &brush = mState.brush();
    const double side = longerSide(*canvas);
    const Rgba colour = toRgba(brush.colour);
    const double length = (mPoints.back() - mPoints.front()).norm();
    switch (tool()) {
    case DrawingTool::Pen: {
        InkStroke ink;
        for (const Vec2 &point : calmed(mPoints))
            ink.line.points.push_back(Vec3(point.x(), point.y(), 0.0));
        ink.line.pressure = mPressures;
        ink.line.timeSeconds = mTimes;
        ink.colour = colour;
        ink.width = brush.width * side;
        return ink;
    }
    case DrawingTool::Fill:
        if (mPoints.size() < 3)
            return std::nullopt;
        return FilledShape{calmed(mPoints), colour};
    case DrawingTool::Arrow:
        if (length < 2.0 * clickShare * side)
            return std::nullopt;
        return ArrowMark{calmed(mPoints), 1.4 * brush.width * side, colour};
    case DrawingTool::Sticker: {
        StickerMark sticker;
        sticker.name = brush.sticker.toStdString();
        // A click puts it there, a drag says how large it is.
        sticker.place = mPoints.front();
        sticker.size = length < clickShare * side ? 0.35 * side : 2.0 * length;
        sticker.colour = colour;
        return sticker;
    }
    default:
        return std::nullopt;
    }
}

void DrawingHand::finish(DoodleMark mark, const QString &text)
{
    const Canvas *canvas = mState.document().canvas(mCanvas);
    if (!canvas)
        return;
    mLastMark = std::make_shared<const DoodleMark>(mark);
    if (!mState.document().editDoodle(text, mCanvas, withMark(canvas->doodle, mDrawing, std::move(mark))))
        mLastMark = nullptr;
}

void DrawingHand::paint(QPainter &painter) const
{
    if (mLastMark)
        paintMark(painter, *mLastMark);
    if (!mIsDrawing)
        return;
    if (const std::optional<DoodleMark> mark = unfinished())
        paintMark(painter, *mark);
}

} // namespace ductus
