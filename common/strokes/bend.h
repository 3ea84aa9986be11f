// Bending a stroke at a handle: the place of the handle goes where the hand takes it, the stroke follows ever
// less along its length, and beyond the reach nothing moves.
#pragma once

#include "strokes/stroke.h"

namespace ductus {

/// A handle of a stroke.
struct StrokeHandle
{
    double along = 0.0; // arc length from the beginning, in the unit of the points
    Vec3 point = Vec3::Zero();
};

struct StrokeBend
{
    double along = 0.0;      // arc length of what is dragged, clamped to the stroke
    Vec3 way = Vec3::Zero(); // where it goes from where it is
    double reach = 0.0;      // arc length to both sides over which the stroke follows
    /// The ends stay, and the directions there, unless an end itself is dragged. Of a closed stroke nothing
    /// is pinned: it bends across the place where it begins.
    bool endsArePinned = true;
};

/// Whether the stroke ends where it begins (but for a billionth of its length).
bool isClosedLine(const std::vector<Vec3> &points);

/// \a count (at least 2) handles at equal steps of arc length: of an open stroke both ends are among them, of
/// a closed one the beginning. None of a stroke without length.
std::vector<StrokeHandle> strokeHandles(const std::vector<Vec3> &points, int count);

/// \a points bent. Points are added where those there are stand too far apart to follow the bend; none are
/// taken away, and what lies outside the reach keeps its coordinates exactly.
std::vector<Vec3> bentLine(const std::vector<Vec3> &points, const StrokeBend &bend);

/// The same for a whole stroke with its channels.
Stroke bentStroke(const Stroke &stroke, const StrokeBend &bend);

} // namespace ductus
