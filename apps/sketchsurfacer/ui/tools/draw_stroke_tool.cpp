#include "sketchsurfacer/ui/tools/draw_stroke_tool.h"

#include "sketchsurfacer/ui/tools/painted_line.h"
#include "sketchsurfacer/ui/tools/stroke_snap.h"
#include "sketchsurfacer/ui/viewport/sketch_view.h"

#include <cmath>

namespace ductus {

namespace {

constexpr double stepPixels = 4.0;
constexpr double snapPixels = 10.0;
constexpr double fadeShare = 0.05; // of the diagonal: how far a snapped end bends a line that ends freely
constexpr double mostSag = 0.2;   // of the way between two strokes

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
    // Beside the surface the stroke is drawn at the depth of the one it begins at.
    mPoints.clear();
    if (const std::optional<Vec3> snap = snapPoint(pointer.position, view, snapPixels);
        snap && !view.surfaceAt(pointer.position))
        mPoints = {*snap};
    else
        mPoints = {pointAt(pointer.position, view)};
    mPositions = {pointer.position};
    mIsDrawing = true;
    return true;
}

void DrawStrokeTool::drag(const ViewPointer &pointer, SketchView &view)
{
    if (!mIsDrawing)
        return;
    const QPointF way = pointer.position - mPositions.back();
    if (std::hypot(way.x(), way.y()) < stepPixels)
        return;
    mPoints.push_back(pointAt(pointer.position, view));
    mPositions.push_back(pointer.position);
}

void DrawStrokeTool::release(const ViewPointer &, SketchView &view)
{
    if (!mIsDrawing)
        return;
    mIsDrawing = false;
    const std::vector<Vec3> smooth = smoothed(std::move(mPoints));
    mPoints.clear();
    if (smooth.size() < 2)
        return;
    const std::vector<SnapAnchor> anchors = anchorsOf(mPositions, view, snapPixels);
    const std::vector<Vec3> points = withoutSag(carriedTo(smooth, anchors, fadeShare * view.extent().diagonal()),
                                                anchors, view.camera().eye(), mostSag);
    mLastEnd = points.back();
    mDone(points);
}

void DrawStrokeTool::hover(const ViewPointer &pointer, SketchView &view)
{
    mSnap = snapPoint(pointer.position, view, snapPixels);
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
