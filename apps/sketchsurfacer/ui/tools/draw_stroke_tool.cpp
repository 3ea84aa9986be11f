#include "sketchsurfacer/ui/tools/draw_stroke_tool.h"

#include "sketchsurfacer/ui/tools/painted_line.h"
#include "sketchsurfacer/ui/viewport/sketch_view.h"

#include <cmath>

namespace ductus {

namespace {

constexpr double stepPixels = 4.0;
constexpr double snapPixels = 10.0;

// The point of the stroke under \a position nearest to it on the screen.
std::optional<Vec3> snapped(const QPointF &position, const SketchView &view)
{
    const int line = view.strokeAt(position, snapPixels);
    if (line < 0)
        return std::nullopt;
    std::optional<Vec3> best;
    double nearest = 1e9;
    for (const Vec3 &p : view.strokes()[std::size_t(line)].points)
        if (const std::optional<QPointF> at = view.camera().project(p)) {
            const double d = std::hypot(at->x() - position.x(), at->y() - position.y());
            if (d < nearest) {
                nearest = d;
                best = p;
            }
        }
    return best;
}

// Twice a mean over three neighbours: takes the trembling out, keeps the ends.
std::vector<Vec3> smoothed(std::vector<Vec3> points)
{
    for (int pass = 0; pass < 2; ++pass) {
        const std::vector<Vec3> before = points;
        for (std::size_t i = 1; i + 1 < points.size(); ++i)
            points[i] = 0.25 * before[i - 1] + 0.5 * before[i] + 0.25 * before[i + 1];
    }
    return points;
}

} // namespace

Vec3 DrawStrokeTool::pointAt(const QPointF &position, const SketchView &view) const
{
    if (const std::optional<RayHit> hit = view.surfaceAt(position))
        return hit->point;
    const Vec3 through = !mPoints.empty() ? mPoints.back() : mLastEnd.value_or(view.extent().centre());
    return view.camera().onViewPlane(position, through);
}

bool DrawStrokeTool::press(const ViewPointer &pointer, SketchView &view)
{
    const std::optional<Vec3> snap = snapped(pointer.position, view);
    mPoints = {snap ? *snap : pointAt(pointer.position, view)};
    mLast = pointer.position;
    mIsDrawing = true;
    return true;
}

void DrawStrokeTool::drag(const ViewPointer &pointer, SketchView &view)
{
    const QPointF way = pointer.position - mLast;
    if (!mIsDrawing || std::hypot(way.x(), way.y()) < stepPixels)
        return;
    mPoints.push_back(pointAt(pointer.position, view));
    mLast = pointer.position;
}

void DrawStrokeTool::release(const ViewPointer &pointer, SketchView &view)
{
    if (!mIsDrawing)
        return;
    mIsDrawing = false;
    if (const std::optional<Vec3> end = snapped(pointer.position, view); end && mPoints.size() > 2)
        mPoints.push_back(*end);
    const std::vector<Vec3> points = smoothed(std::move(mPoints));
    mPoints.clear();
    if (points.size() < 2)
        return;
    mLastEnd = points.back();
    mDone(points);
}

void DrawStrokeTool::hover(const ViewPointer &pointer, SketchView &view)
{
    mSnap = snapped(pointer.position, view);
}

bool DrawStrokeTool::cancel(SketchView &)
{
    const bool had = mIsDrawing;
    mIsDrawing = false;
    mPoints.clear();
    mSnap.reset();
    return had;
}

void DrawStrokeTool::paint(QPainter &painter, const SketchView &view) const
{
    if (!mPoints.empty())
        paintLine(painter, view, mPoints, QColor(110, 170, 255), 2.5);
    if (!mSnap || mIsDrawing)
        return;
    if (const std::optional<QPointF> at = view.camera().project(*mSnap)) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(110, 170, 255), 2.0));
        painter.drawEllipse(*at, 6, 6);
    }
}

} // namespace ductus
