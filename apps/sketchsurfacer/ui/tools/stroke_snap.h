// Bringing a line that was drawn on a surface to the strokes it meets. The surface may run below them, as it
// does where a crease is missing: a line from stroke to stroke is meant at their height all along.
#pragma once

#include "geometry/triangle_mesh.h"

#include <QPointF>
#include <optional>
#include <vector>

namespace ductus {

class SketchView;

/// Where point \a index of a line is to go.
struct SnapAnchor
{
    std::size_t index = 0;
    Vec3 target = Vec3::Zero();
};

/// \a points so that those of \a anchors (ascending) are at their targets; between two anchors the way there
/// is shared by length, and beyond the outer ones it fades out over \a fade, scene units.
std::vector<Vec3> carriedTo(std::vector<Vec3> points, const std::vector<SnapAnchor> &anchors, double fade);

/// \a points, carried to \a anchors, where they run behind the straight way between two of them as seen from
/// \a eye brought onto it: the surface sags there since the line was missing. What hangs lower than
/// \a mostShare of the way is a hollow that is meant and stays.
std::vector<Vec3> withoutSag(std::vector<Vec3> points, const std::vector<SnapAnchor> &anchors, const Vec3 &eye,
                             double mostShare);

/// The point of the visible stroke under \a position nearest to it on the screen, within \a reach pixels; not
/// of line \a except.
std::optional<Vec3> snapPoint(const QPointF &position, const SketchView &view, double reach, int except = -1);

/// The strokes a line drawn over \a positions (pixels) meets: at its ends within \a endReach pixels, on its
/// way where it crosses one.
std::vector<SnapAnchor> anchorsOf(const std::vector<QPointF> &positions, const SketchView &view,
                                  double endReach);

} // namespace ductus
