// Strokes with fewer points, for when they are far away.
#pragma once

#include "painting/scene/element.h"

namespace ductus {

struct CoarseStroke
{
    StrokeShape shape;
    double error = 0; // by how much its skin may differ from the stroke's, element's unit
};

/// Leaves out points [Douglas, Peucker 1973] where place, half width and colour run straight enough: the
/// error is half the greatest half width, a step of colour counts as that much. First and last point stay.
CoarseStroke coarseStroke(const StrokeShape &stroke);

} // namespace ductus
