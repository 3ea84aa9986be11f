#include "sketchsurfacer/ui/tools/stroke_snap.h"

#include "sketchsurfacer/ui/viewport/sketch_view.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ductus {

namespace {

constexpr double crossingReach = 4.0; // pixels: the line runs over the stroke

struct Snap
{
    Vec3 point;
    double pixels = 0.0;
};

std::optional<Snap> nearestOf(int line, const QPointF &position, const SketchView &view)
{
    std::optional<Snap> best;
    for (const Vec3 &p : view.strokes()[std::size_t(line)].points)
        if (const std::optional<QPointF> at = view.camera().project(p)) {
            const double d = std::hypot(at->x() - position.x(), at->y() - position.y());
            if (!best || d < best->pixels)
                best = Snap{p, d};
        }
    return best;
}

} // namespace

std::vector<Vec3> carriedTo(std::vector<Vec3> points, const std::vector<SnapAnchor> &anchors, double fade)
{
    if (anchors.empty() || points.empty())
        return points;
    std::vector<double> along(points.size(), 0.0);
    for (std::size_t i = 1; i < points.size(); ++i)
        along[i] = along[i - 1] + (points[i] - points[i - 1]).norm();
    const std::vector<Vec3> before = points;
    const auto way = [&](const SnapAnchor &anchor) { return Vec3(anchor.target - before[anchor.index]); };
    const auto faded = [&](double distance) {
        const double share = std::clamp(1.0 - distance / std::max(fade, 1e-300), 0.0, 1.0);
        return share * share * (3.0 - 2.0 * share);
    };
    std::size_t next = 0; // the first anchor at or behind the point
    for (std::size_t i = 0; i < points.size(); ++i) {
        while (next < anchors.size() && anchors[next].index < i)
            ++next;
        if (next == anchors.size()) {
            points[i] += faded(along[i] - along[anchors.back().index]) * way(anchors.back());
        } else if (next == 0) {
            points[i] += faded(along[anchors[0].index] - along[i]) * way(anchors[0]);
        } else {
            const SnapAnchor &a = anchors[next - 1], &b = anchors[next];
            const double length = along[b.index] - along[a.index];
            const double share = length > 0.0 ? (along[i] - along[a.index]) / length : 1.0;
            points[i] += (1.0 - share) * way(a) + share * way(b);
        }
    }
    return points;
}

std::vector<Vec3> withoutSag(std::vector<Vec3> points, const std::vector<SnapAnchor> &anchors, const Vec3 &eye,
                             double mostShare)
{
    for (std::size_t k = 0; k + 1 < anchors.size(); ++k) {
        const std::size_t begin = anchors[k].index, end = anchors[k + 1].index;
        const Vec3 from = points[begin], chord = points[end] - from;
        if (end <= begin + 1 || !(chord.norm() > 0.0))
            continue;
        std::vector<double> sags;
        for (std::size_t i = begin; i <= end; ++i) {
            const double share = std::clamp((points[i] - from).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
            sags.push_back((points[i] - from - share * chord).dot((points[i] - eye).normalized()));
        }
        if (*std::max_element(sags.begin(), sags.end()) > mostShare * chord.norm())
            continue;
        for (std::size_t i = begin; i <= end; ++i)
            points[i] -= std::max(0.0, sags[i - begin]) * (points[i] - eye).normalized();
    }
    return points;
}

std::optional<Vec3> snapPoint(const QPointF &position, const SketchView &view, double reach, int except)
{
    const int line = view.strokeAt(position, reach, except);
    if (line < 0)
        return std::nullopt;
    const std::optional<Snap> snap = nearestOf(line, position, view);
    return snap ? std::optional(snap->point) : std::nullopt;
}

std::vector<SnapAnchor> anchorsOf(const std::vector<QPointF> &positions, const SketchView &view,
                                  double endReach)
{
    std::vector<SnapAnchor> anchors;
    if (positions.empty())
        return anchors;
    const std::size_t last = positions.size() - 1;
    const std::optional<Vec3> start = snapPoint(positions.front(), view, endReach);
    const std::optional<Vec3> end = last > 1 ? snapPoint(positions.back(), view, endReach) : std::nullopt;
    if (start)
        anchors.push_back({0, *start});
    // Of each stroke on the way the place where the line comes nearest to it.
    struct Crossing
    {
        std::size_t index = 0;
        Snap snap;
    };
    std::map<int, Crossing> crossings;
    const auto isNearEnd = [&](std::size_t i) {
        const QPointF a = positions[i] - positions.front(), b = positions[i] - positions.back();
        return std::hypot(a.x(), a.y()) < 3.0 * endReach || std::hypot(b.x(), b.y()) < 3.0 * endReach;
    };
    for (std::size_t i = 1; i < last; ++i) {
        const int line = isNearEnd(i) ? -1 : view.strokeAt(positions[i], crossingReach);
        if (line < 0)
            continue;
        const std::optional<Snap> snap = nearestOf(line, positions[i], view);
        const auto known = crossings.find(line);
        if (snap && (known == crossings.end() || snap->pixels < known->second.snap.pixels))
            crossings[line] = {i, *snap};
    }
    std::map<std::size_t, Snap> byIndex;
    for (const auto &[line, crossing] : crossings)
        if (const auto known = byIndex.find(crossing.index);
            known == byIndex.end() || crossing.snap.pixels < known->second.pixels)
            byIndex[crossing.index] = crossing.snap;
    for (const auto &[index, snap] : byIndex)
        anchors.push_back({index, snap.point});
    if (end)
        anchors.push_back({last, *end});
    return anchors;
}

} // namespace ductus
