#include "sketchsurfacer/ui/tools/stroke_handles.h"

#include "sketchsurfacer/ui/tools/painted_line.h"
#include "sketchsurfacer/ui/tools/stroke_snap.h"
#include "sketchsurfacer/ui/viewport/sketch_view.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double grabReach = 9.0;   // pixels around a handle
constexpr double snapReach = 8.0;   // pixels to another stroke
constexpr double leastDrag = 3.0;   // pixels; less is a click
constexpr double handleStep = 0.14; // of the diagonal: long strokes have more handles
constexpr double leastGap = 30.0;   // pixels between two handles: the stroke can be grabbed there, too
constexpr int fewest = 3, most = 8;
constexpr double reachStep = 1.2; // by which a notch of the wheel changes the reach
constexpr double leastReach = 0.4, mostReach = 8.0;
const QColor highlight(255, 214, 110), ink(28, 31, 36);

double screenLength(const std::vector<Vec3> &points, const SketchView &view)
{
    double length = 0.0;
    std::optional<QPointF> before;
    for (const Vec3 &p : points) {
        const std::optional<QPointF> at = view.camera().project(p);
        if (before && at)
            length += std::hypot(at->x() - before->x(), at->y() - before->y());
        before = at;
    }
    return length;
}

double handleDistance(const std::vector<Vec3> &points, std::size_t count)
{
    const std::size_t steps = isClosedLine(points) ? count : count - 1;
    return polylineLength(points) / double(std::max<std::size_t>(steps, 1));
}

} // namespace

const std::vector<Vec3> *StrokeHandles::line(const SketchView &view) const
{
    const int chosen = mActions.chosenLine();
    if (chosen < 0 || chosen >= int(view.strokes().size()) ||
        !(view.areStrokesShown() || view.mode() == ViewMode::Sketch))
        return nullptr;
    const std::vector<Vec3> &points = view.strokes()[std::size_t(chosen)].points;
    return points.size() < 2 ? nullptr : &points;
}

std::vector<StrokeHandle> StrokeHandles::handles(const SketchView &view) const
{
    const std::vector<Vec3> *points = line(view);
    const double diagonal = view.extent().isEmpty() ? 0.0 : view.extent().diagonal();
    if (!points || diagonal <= 0.0)
        return {};
    const double steps = polylineLength(*points) / (handleStep * diagonal);
    const int count = std::clamp(int(std::lround(steps)) + 1, fewest, most);
    const int room = int(screenLength(*points, view) / leastGap);
    return room < 1 ? std::vector<StrokeHandle>() : strokeHandles(*points, std::min(count, room + 1));
}

int StrokeHandles::handleAt(const QPointF &position, const SketchView &view) const
{
    const std::vector<StrokeHandle> all = handles(view);
    int best = -1;
    double nearest = grabReach;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (const std::optional<QPointF> at = view.camera().project(all[i].point))
            if (const double d = std::hypot(at->x() - position.x(), at->y() - position.y()); d < nearest) {
                nearest = d;
                best = int(i);
            }
    return best;
}

bool StrokeHandles::press(const ViewPointer &pointer, const SketchView &view)
{
    const int index = handleAt(pointer.position, view);
    if (index < 0)
        return false;
    const std::vector<StrokeHandle> all = handles(view);
    const StrokeHandle &handle = all[std::size_t(index)];
    Drag drag;
    drag.grabbed = handle.point;
    drag.from = pointer.position;
    drag.bend.along = handle.along;
    drag.bend.reach = mReachFactor * handleDistance(*line(view), all.size());
    mDrag = drag;
    mHovered = index;
    return true;
}

Vec3 StrokeHandles::target(const ViewPointer &pointer, const SketchView &view, bool *snaps) const
{
    const int own = mActions.chosenLine();
    *snaps = false;
    if (const std::optional<Vec3> other = snapPoint(pointer.position, view, snapReach, own)) {
        *snaps = true;
        return *other;
    }
    if (pointer.modifiers & Qt::ControlModifier)
        if (const std::optional<RayHit> hit = view.surfaceAt(pointer.position))
            return hit->point;
    // What was grabbed beside its middle is not jerked there.
    const std::optional<QPointF> at = view.camera().project(mDrag->grabbed);
    const QPointF beside = at ? mDrag->from - *at : QPointF();
    return view.camera().onViewPlane(pointer.position - beside, mDrag->grabbed);
}

bool StrokeHandles::drag(const ViewPointer &pointer, const SketchView &view)
{
    if (!mDrag)
        return false;
    const QPointF way = pointer.position - mDrag->from;
    mDrag->moved = mDrag->moved || std::hypot(way.x(), way.y()) >= leastDrag;
    if (mDrag->moved)
        mDrag->bend.way = target(pointer, view, &mDrag->snaps) - mDrag->grabbed;
    return true;
}

bool StrokeHandles::release()
{
    const std::optional<Drag> drag = std::exchange(mDrag, std::nullopt);
    if (!drag)
        return false;
    if (drag->moved && !drag->bend.way.isZero(0.0))
        mActions.bent(drag->bend);
    return true;
}

bool StrokeHandles::hover(const ViewPointer &pointer, const SketchView &view)
{
    mHovered = handleAt(pointer.position, view);
    return mHovered >= 0;
}

bool StrokeHandles::wheel(double steps, const SketchView &view)
{
    if (!mDrag)
        return false;
    const double before = mReachFactor;
    mReachFactor = std::clamp(mReachFactor * std::pow(reachStep, steps), leastReach, mostReach);
    mDrag->bend.reach *= mReachFactor / before;
    return line(view) != nullptr;
}

bool StrokeHandles::cancel()
{
    mHovered = -1;
    return std::exchange(mDrag, std::nullopt).has_value();
}

void StrokeHandles::paint(QPainter &painter, const SketchView &view) const
{
    const std::vector<Vec3> *points = line(view);
    if (!points)
        return;
    std::vector<StrokeHandle> all = handles(view);
    if (mDrag && mDrag->moved) {
        paintLine(painter, view, bentLine(*points, mDrag->bend), highlight, 2.5);
        all = {{mDrag->bend.along, mDrag->grabbed + mDrag->bend.way}};
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::optional<QPointF> at = view.camera().project(all[i].point);
        if (!at)
            continue;
        const bool isMeant = mDrag ? mDrag->moved || int(i) == mHovered : int(i) == mHovered;
        const double radius = isMeant ? 6.0 : 4.5;
        painter.setPen(QPen(ink, 1.5));
        painter.setBrush(isMeant ? highlight : QColor(250, 250, 252));
        painter.drawEllipse(*at, radius, radius);
        if (mDrag && mDrag->snaps) {
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(highlight, 1.5));
            painter.drawEllipse(*at, radius + 5, radius + 5);
        }
    }
}

} // namespace ductus
