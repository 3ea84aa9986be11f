// What the surface command tells of a sketch that leaves more than one surface open: a picture or JSON.
#pragma once

#include "surfacing/pipeline/surfacing_state.h"

#include <filesystem>

namespace ductus {

/// The map on the proxy with the strokes, as PNG, or its numbers and the other readings, as JSON: by the
/// ending of \a path. Takes as long as labelling with ten runs.
Result<std::vector<std::byte>> ambiguityBytes(const SurfacingState &state, const std::filesystem::path &path,
                                              const JobControl &control);

} // namespace ductus
