// The whole of thesis chapter III (Fig. III.3): sketch -> proxy -> association -> segmentation -> extraction.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "surfacing/pipeline/surface_options.h"
#include "surfacing/pipeline/surface_result.h"

namespace ductus {

/// \a strokes as read; \a givenProxy in the same coordinates, or nothing for the automatic one. For scribbles and
/// re-solves see surfacing_state.h, whose stages this runs in a row.
Result<SurfaceResult> surfaceSketch(const StrokeSet &strokes, const std::optional<TriangleMesh> &givenProxy,
                                    const SurfaceOptions &options, const JobControl &control);

} // namespace ductus
