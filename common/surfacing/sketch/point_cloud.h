// Sketches of points that do not follow one another: each is a stroke of a single point.
#pragma once

#include "base/result.h"
#include "strokes/stroke.h"

namespace ductus {

/// True if nearly all strokes are single points, and there are many.
bool isPointCloud(const StrokeSet &strokes);

/// Without points given twice. Ids and order of the rest are kept.
StrokeSet cleanedCloud(const StrokeSet &cloud);

/// Refused with TooLittleData or NoSolution where there are too few points for a surface, or where they fill
/// a volume and lie on none.
Result<void> checkCloudIsSurface(const StrokeSet &cloud);

} // namespace ductus
