// From the centreline of a stroke to the segments of its solid (section.h).
#pragma once

#include "painting/coverage/section.h"

#include <vector>

namespace ductus {

/// Appends the segments of \a stroke in the space of \a sceneFromElement (a Placement's matrix: mirrored ones
/// give the mirrored solid), in the order of its points.
///
/// Frames as Quill's: T the mean direction of both neighbours, U = normal x T, V = T x U. Sections are the
/// same under half a turn, so that U may change its sign from a point to the next; where it turns by more
/// than 2 degrees between two points, the segment is cut into shorter ones. Points at one place are one
/// point, as wide as the widest. Neighbours share the mitre plane where the stroke is smooth; at sharp bends,
/// sudden widths and where points are denser than hands are steady, round segments keep their whole balls and
/// flat ones end on their own, with a piece between that fills the wedge. A stroke of one place is a dab: a
/// ball, or as long as it is wide.
///
/// Reach directions are left zero. \a colour, if given, goes before the points' own.
void appendStrokeSegments(const StrokeShape &stroke, const Eigen::Affine3d &sceneFromElement,
                          std::uint32_t element, const std::optional<Eigen::Vector3f> &colour,
                          std::vector<SegmentData> &segments);

} // namespace ductus
