// sRGB bytes <-> linear light. Light adds up only in linear numbers.
#pragma once

#include "geometry/triangle_mesh.h"
#include "imaging/image.h"

namespace ductus::picture {

/// Linear RGB in 0..1 of an sRGB colour [IEC 61966-2-1]; alpha is ignored.
Vec3 linearFromRgba(Rgba colour);

/// Opaque sRGB of linear RGB; values beyond 0..1 are cut.
Rgba rgbaFromLinear(const Vec3 &linear);

} // namespace ductus::picture
