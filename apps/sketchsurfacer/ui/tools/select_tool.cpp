#include "sketchsurfacer/ui/tools/select_tool.h"

#include "sketchsurfacer/ui/tools/painted_line.h"
#include "sketchsurfacer/ui/tools/stroke_snap.h"
#include "sketchsurfacer/ui/viewport/sketch_view.h"

namespace ductus {

namespace {

constexpr double reach = 9.0;      // pixels around a stroke that grab it
constexpr double leastLasso = 6.0; // pixels; less is a click
const QColor highlight(255, 214, 110);

int strokeUnder(const QPointF &position, const SketchView &view)
{
    return view.areStrokesShown() || view.mode() == ViewMode::Sketch ? view.strokeAt(position, reach) : -1;
}

bool extends(const ViewPointer &pointer)
{
    return pointer.modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
}

} // namespace

std::vector<int> linesInLasso(const QPolygonF &lasso, const SketchView &view)
{
    std::vector<int> lines;
    for (std::size_t i = 0; i < view.strokes().size(); ++i) {
        const std::vector<Vec3> &points = view.strokes()[i].points;
        std::size_t inside = 0;
        for (const Vec3 &p : points)
            if (const std::optional<QPointF> at = view.camera().project(p))
                inside += lasso.containsPoint(*at, Qt::OddEvenFill);
        if (2 * inside > points.size())
            lines.push_back(int(i));
    }
    return lines;
}

bool SelectTool::press(const ViewPointer &pointer, SketchView &view)
{
    if (!(pointer.modifiers & Qt::ShiftModifier) && mHandles.press(pointer, view))
        return true;
    if (extends(pointer)) {
        mLasso = {pointer.position};
        return true;
    }
    const int line = strokeUnder(pointer.position, view);
    if (line < 0 || !mActions.isChosen(line))
        return false;
    mMove = Move{snapPoint(pointer.position, view, reach).value_or(view.extent().centre()), Vec3::Zero()};
    return true;
}

void SelectTool::drag(const ViewPointer &pointer, SketchView &view)
{
    if (mHandles.drag(pointer, view))
        return;
    if (mMove)
        mMove->way = view.camera().onViewPlane(pointer.position, mMove->grabbed) - mMove->grabbed;
    else if (!mLasso.isEmpty())
        mLasso << pointer.position;
}

void SelectTool::release(const ViewPointer &pointer, SketchView &view)
{
    if (mHandles.release())
        return;
    if (const std::optional<Move> move = std::exchange(mMove, std::nullopt)) {
        const double pixels = move->way.norm() / view.camera().unitsPerPixel(move->grabbed);
        if (pixels < leastLasso)
            click(pointer, view);
        else
            mActions.moved(move->way);
        return;
    }
    const QPolygonF lasso = std::exchange(mLasso, {});
    const QSizeF size = lasso.boundingRect().size();
    if (std::max(size.width(), size.height()) < leastLasso)
        click(pointer, view);
    else
        mActions.lassoed(linesInLasso(lasso, view), pointer.modifiers & Qt::ControlModifier);
}

void SelectTool::click(const ViewPointer &pointer, SketchView &view)
{
    const int line = strokeUnder(pointer.position, view);
    if (line >= 0)
        mActions.strokeClicked(line, extends(pointer));
    else if (view.surfaceAt(pointer.position))
        mActions.surfaceClicked(pointer.position);
    else if (!extends(pointer))
        mActions.nothingClicked();
}

void SelectTool::hover(const ViewPointer &pointer, SketchView &view)
{
    if (mHandles.hover(pointer, view)) {
        mHovered = -1;
        view.setCursor(Qt::OpenHandCursor);
        return;
    }
    mHovered = strokeUnder(pointer.position, view);
    view.setCursor(mHovered < 0                  ? Qt::ArrowCursor
                   : mActions.isChosen(mHovered) ? Qt::SizeAllCursor
                                                 : Qt::PointingHandCursor);
}

bool SelectTool::cancel(SketchView &)
{
    mHovered = -1;
    const bool had = mHandles.cancel() || mMove || !mLasso.isEmpty();
    mMove.reset();
    mLasso.clear();
    return had;
}

void SelectTool::paint(QPainter &painter, const SketchView &view) const
{
    if (!mLasso.isEmpty()) {
        painter.setBrush(QColor(255, 214, 110, 36));
        painter.setPen(QPen(highlight, 1.5, Qt::DashLine));
        painter.drawPolygon(mLasso);
        return;
    }
    if (mMove) {
        for (std::size_t i = 0; i < view.strokes().size(); ++i) {
            if (!mActions.isChosen(int(i)))
                continue;
            std::vector<Vec3> points = view.strokes()[i].points;
            for (Vec3 &p : points)
                p += mMove->way;
            paintLine(painter, view, points, highlight, 2.5);
        }
        return;
    }
    if (mHovered >= 0 && mHovered < int(view.strokes().size()))
        paintLine(painter, view, view.strokes()[std::size_t(mHovered)].points, highlight, 2.5);
    mHandles.paint(painter, view);
}

} // namespace ductus
