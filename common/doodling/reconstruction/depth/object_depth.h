// How far away what moves by itself is: as far as the ground it stands on. One depth an object and frame,
// smoothed over time.
#pragma once

#include "doodling/reconstruction/shot.h"

#include <array>

namespace ductus {

/// By object number; 0: the object is not in the frame.
using ObjectDisparities = std::array<float, 256>;

/// \a background is the disparity of what stands still, behind objects filled in; both row by row.
ObjectDisparities contactDisparities(const std::vector<std::uint8_t> &objects,
                                     const std::vector<float> &background, int width, int height);

/// A few frames to each side, in logarithms.
void smoothOverTime(std::vector<ObjectDisparities> &frames);

} // namespace ductus
