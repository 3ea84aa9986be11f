// Joining loose two-point segments into strokes, for files that write a polyline as one record a segment.
#pragma once

#include "geometry/triangle_mesh.h"

#include <array>
#include <vector>

namespace ductus {

using Segment = std::array<int, 2>; // two different vertex indices

/// Polylines of vertex indices that use each segment once. Segments are chained
/// - at every vertex where exactly two segments meet;
/// - at a vertex where three or four meet, through the pairs that go straight on: turning by less than 30
/// degrees,
///   straightest pair first. So a line that others cross or end on stays one stroke.
/// At all other vertices strokes end. A chain that comes back to its start is closed: first index == last
/// index.
///
/// The order of the result is that of the first segment of each chain in \a segments. A chain runs the way
/// its segments follow one another in the file (most steps upwards), which is the drawing order in the
/// exports met; where that does not decide, the way its first segment runs. A closed chain without junction
/// starts at its first segment. Takes O(n log n).
std::vector<std::vector<int>> chainSegments(const std::vector<Segment> &segments,
                                            const std::vector<Vec3> &vertices);

} // namespace ductus
