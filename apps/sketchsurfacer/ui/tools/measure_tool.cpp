#include "sketchsurfacer/ui/tools/measure_tool.h"

#include "sketchsurfacer/ui/tools/painted_line.h"
#include "sketchsurfacer/ui/viewport/length_text.h"
#include "sketchsurfacer/ui/viewport/sketch_view.h"

#include <cmath>

namespace ductus {

std::optional<Vec3> MeasureTool::pointAt(const QPointF &position, const SketchView &view) const
{
    if (const int line = view.strokeAt(position, 8.0); line >= 0) {
        std::optional<Vec3> best;
        double nearest = 1e9;
        for (const Vec3 &p : view.strokes()[std::size_t(line)].points)
            if (const auto at = view.camera().project(p)) {
                const double d = std::hypot(at->x() - position.x(), at->y() - position.y());
                if (d < nearest) {
                    nearest = d;
                    best = p;
                }
            }
        return best;
    }
    if (const std::optional<RayHit> hit = view.surfaceAt(position))
        return hit->point;
    return std::nullopt;
}

void MeasureTool::click(const ViewPointer &pointer, SketchView &view)
{
    const std::optional<Vec3> point = pointAt(pointer.position, view);
    if (!point)
        return;
    if (!mFrom || mTo) {
        mFrom = point;
        mTo.reset();
    } else {
        mTo = point;
        mMeasured((*mTo - *mFrom).norm());
    }
}

void MeasureTool::hover(const ViewPointer &pointer, SketchView &view)
{
    mUnder = pointAt(pointer.position, view);
}

bool MeasureTool::cancel(SketchView &)
{
    const bool had = mFrom.has_value();
    mFrom.reset();
    mTo.reset();
    mUnder.reset();
    return had;
}

void MeasureTool::paint(QPainter &painter, const SketchView &view) const
{
    const std::optional<Vec3> to = mTo ? mTo : mFrom ? mUnder : std::nullopt;
    const QColor colour(255, 214, 110);
    if (mUnder && !mTo)
        paintLine(painter, view, {*mUnder}, colour, 7.0);
    if (!mFrom)
        return;
    paintLine(painter, view, {*mFrom}, colour, 7.0);
    if (!to)
        return;
    paintLine(painter, view, {*mFrom, *to}, colour, 2.0);
    paintLine(painter, view, {*to}, colour, 7.0);
    const std::optional<QPointF> middle = view.camera().project(0.5 * (*mFrom + *to));
    if (!middle)
        return;
    const QString text = lengthText((*to - *mFrom).norm() * view.metresPerUnit(), view.locale());
    QRectF box = painter.fontMetrics().boundingRect(text).adjusted(-8, -4, 8, 4);
    box.moveCenter(*middle + QPointF(0, -18));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 22, 26, 220));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(QColor(240, 242, 245));
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace ductus
