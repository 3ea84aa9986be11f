// The stages of prepareSurfacing, each filling its part of a state from the parts before it.
#pragma once

#include "surfacing/pipeline/surfacing_state.h"

namespace ductus {

Result<void> prepareSketch(SurfacingState &state, const StrokeSet &strokes);

/// Other strokes in the frame of \a sketch, as it has them: even steps, only the solved half.
StrokeSet strokesInFrame(const StrokeSet &strokes, const PreparedSketch &sketch,
                         const SurfaceOptions &options);

Result<void> prepareProxy(SurfacingState &state, const std::optional<TriangleMesh> &givenProxy,
                          const JobControl &control);

/// And trims away what lies beyond the border of an open surface.
Result<void> prepareAssociation(SurfacingState &state, const JobControl &control);

/// Both halves of the proxy in input coordinates.
std::shared_ptr<const TriangleMesh> proxyToShow(const SurfacingState &state);

} // namespace ductus
