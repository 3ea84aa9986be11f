#include "sketchsurfacer/ui/tools/scribble_tool.h"

#include "sketchsurfacer/ui/tools/painted_line.h"
#include "sketchsurfacer/ui/viewport/sketch_view.h"

#include <cmath>

namespace ductus {

namespace {

constexpr double stepPixels = 3.0;

} // namespace

ScribbleTool::ScribbleTool(ScribbleKind kind, QColor colour, int leastPoints,
                           std::function<void(const Scribble &)> done)
    : mKind(kind), mColour(std::move(colour)), mLeastPoints(leastPoints), mDone(std::move(done))
{
}

void ScribbleTool::setKind(ScribbleKind kind, QColor colour, int leastPoints)
{
    mKind = kind;
    mColour = std::move(colour);
    mLeastPoints = leastPoints;
}

void ScribbleTool::add(const QPointF &position, const SketchView &view)
{
    if (const std::optional<RayHit> hit = view.surfaceAt(position)) {
        mPoints.push_back(hit->point);
        mLast = position;
    }
}

bool ScribbleTool::press(const ViewPointer &pointer, SketchView &view)
{
    mPoints.clear();
    add(pointer.position, view);
    mIsDrawing = !mPoints.empty();
    return mIsDrawing;
}

void ScribbleTool::drag(const ViewPointer &pointer, SketchView &view)
{
    if (!mIsDrawing)
        return; // given up with Esc while the button is down
    mHover = pointer.position;
    // A quick hand leaves pixels out: the line between them lies on the surface as well.
    const QPointF from = mLast, way = pointer.position - from;
    const int steps = std::min(200, int(std::hypot(way.x(), way.y()) / stepPixels));
    for (int i = 1; i <= steps; ++i)
        add(from + way * (double(i) / steps), view);
}

void ScribbleTool::release(const ViewPointer &, SketchView &view)
{
    if (!mIsDrawing)
        return;
    mIsDrawing = false;
    Scribble scribble;
    scribble.kind = mKind;
    scribble.points = std::move(mPoints);
    mPoints.clear();
    if (int(scribble.points.size()) >= mLeastPoints)
        mDone(scribble);
}

void ScribbleTool::hover(const ViewPointer &pointer, SketchView &view)
{
    mHover = pointer.position;
    mIsOverSurface = view.surfaceAt(pointer.position).has_value();
    view.setCursor(mIsOverSurface ? Qt::BlankCursor : Qt::CrossCursor);
}

bool ScribbleTool::cancel(SketchView &)
{
    const bool had = mIsDrawing;
    mIsDrawing = false;
    mIsOverSurface = false;
    mPoints.clear();
    return had;
}

void ScribbleTool::paint(QPainter &painter, const SketchView &view) const
{
    if (!mPoints.empty())
        paintLine(painter, view, mPoints, mColour, 4.0);
    if (mIsOverSurface) {
        painter.setBrush(mColour);
        painter.setPen(QPen(QColor(0, 0, 0, 150), 1.2));
        painter.drawEllipse(mHover, 4.5, 4.5);
    }
}

} // namespace ductus
