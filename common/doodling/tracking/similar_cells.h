// The cells a rough path may go through: those of each frame that look most like the keyframes (thesis
// VI.5.2).
#pragma once

#include "doodling/tracking/track_point.h"

namespace ductus {

/// Indices into the frame's feature grid, ascending: the \a share most similar ones to the keyframes before
/// and after the frame. A frame with a keyframe has that one's cell only.
std::vector<std::vector<int>> similarCells(const Shot &shot, const std::vector<CanvasKeyframe> &keyframes,
                                           double share);

} // namespace ductus
