// The stages of prepareSurfacing, each filling its part of a state from the parts before it.
#pragma once

#include "surfacing/pipeline/surfacing_state.h"

namespace ductus {

void prepareSketch(SurfacingState &state, const StrokeSet &strokes);

Result<void> prepareProxy(SurfacingState &state, const std::optional<TriangleMesh> &givenProxy,
                          const JobControl &control);

/// And trims away what lies beyond the border of an open surface.
Result<void> prepareAssociation(SurfacingState &state, const JobControl &control);

} // namespace ductus
