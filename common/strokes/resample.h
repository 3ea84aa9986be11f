// Resampling of strokes to an even step, and clean-up of what people's files contain.
#pragma once

#include "strokes/stroke.h"

namespace ductus {

/// Points at equal arc length along \a points, none further apart than \a step; both ends are kept.
/// A polyline without length gives its first point alone. Channels are interpolated by the Stroke overload.
std::vector<Vec3> resampled(const std::vector<Vec3> &points, double step);

/// The same for a whole stroke with its channels.
Stroke resampled(const Stroke &stroke, double step);

/// Drops consecutive equal points, strokes with fewer than two points left, and exact duplicates of earlier
/// strokes (same points, forwards or backwards). Ids and order of the rest are kept.
StrokeSet cleaned(const StrokeSet &set);

} // namespace ductus
