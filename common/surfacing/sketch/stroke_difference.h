// What an edit of a sketch changed: the strokes that went and the strokes that came.
#pragma once

#include "strokes/stroke.h"

namespace ductus {

/// A moved stroke, or one with another role, stands in both.
struct StrokeDifference
{
    std::vector<Stroke> removed; // in the order of the old sketch
    std::vector<Stroke> added;   // in the order of the new one

    bool isEmpty() const { return removed.empty() && added.empty(); }
    /// Of the strokes removed or of those added, whichever is more, in the unit of the sketch.
    double length() const;
    bool hasBoundaryStrokes() const;
};

/// Compares the strokes that carry surface (roles Surface and Boundary) by role and points, whatever their
/// ids and their order: a renumbered sketch is the same sketch.
StrokeDifference differenceBetween(const StrokeSet &before, const StrokeSet &after);

} // namespace ductus
