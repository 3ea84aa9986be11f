// What the thing at a keyframe looks like: a patch in which places that move otherwise than its middle count
// little. They are of what is behind or before the thing, and something else is there a moment later.
#pragma once

#include "doodling/tracking/follow_pixel.h"
#include "doodling/tracking/patch.h"

namespace ductus {

/// \a shot has pictures.
Patch thingPatchAt(const Shot &shot, const PixelKeyframe &keyframe);

} // namespace ductus
