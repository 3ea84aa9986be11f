// The report of the surface command: what was done, how long it took, how well the surface fits.
#pragma once

#include "strokes/stroke.h"
#include "surfacing/pipeline/surface_options.h"
#include "surfacing/pipeline/surface_result.h"

#include <nlohmann/json.hpp>

namespace ductus {

/// \a input: the name of the sketch.
nlohmann::ordered_json surfaceReport(const std::string &input, int scribbles, const StrokeSet &strokes,
                                     const SurfaceOptions &options, const SurfaceResult &result);

} // namespace ductus
