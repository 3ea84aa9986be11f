// Colours for pixels that cannot be seen, so that encoders which blur colour more than transparency (4:2:0)
// draw no dark seam around what can be seen.
#pragma once

#include "imaging/image.h"

namespace ductus {

/// Pixels of alpha 0 get the mean colour of what is visible nearby, a step coarser until something is; all
/// others, and every alpha, stay.
Image withFilledColours(const Image &image);

} // namespace ductus
