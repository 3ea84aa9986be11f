// Which strokes the solver took for the border of an open surface although nobody marked them.
#pragma once

#include "surfacing/pipeline/surfacing_state.h"

namespace ductus {

/// Of \a strokes, those \a state ends along that have not the role of a border; with a mirror plane also
/// their images on the half that was not solved. In the order of the strokes; none for a closed surface, or
/// where only the mesh is known.
std::vector<StrokeId> foundBorders(const StrokeSet &strokes, const SurfacingState &state);

} // namespace ductus
