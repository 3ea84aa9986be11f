// The picture of the surface command: the sketch beside its surface, regions coloured, creases dark.
#pragma once

#include "imaging/image.h"
#include "strokes/stroke.h"
#include "surfacing/pipeline/surface_result.h"

namespace ductus {

Image resultPicture(const StrokeSet &strokes, const SurfaceResult &result);

} // namespace ductus
