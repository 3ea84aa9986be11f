// The report of the surface command: what was done, how long it took, how well the surface fits.
#pragma once

#include "surfacing/pipeline/surface_pipeline.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace ductus {

nlohmann::ordered_json surfaceReport(const std::filesystem::path &input, const StrokeSet &strokes,
                                     const SurfaceOptions &options, const SurfaceResult &result);

} // namespace ductus
