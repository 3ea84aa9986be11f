// The shortest path through proposed places (pixel_path.h). A point that is seen goes by the flow; a
// leap to a place that looks better costs. Edges over several frames stand for stretches in which it is
// hidden and goes with its thing, more or less; each costs something to begin and something a frame, so that
// a point is called hidden only where being seen is the worse explanation.
#pragma once

#include "doodling/tracking/pixel_path.h"

namespace ductus {

/// \a proposals with the keyframe's own place as the first frame, which is frame \a from of the shot;
/// \a direction is 1 or -1. A closed path is seen in its last frame. Pixels of hidden points, turns and
/// growths are left to the caller.
std::vector<PathPoint> bestPath(const Shot &shot, const PathProposals &proposals, int from, int direction,
                                bool isClosed, const PixelPathOptions &options);

} // namespace ductus
