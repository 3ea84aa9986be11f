// The surface command's result as a project that SketchSurfacer opens: sketch, decisions and surface.
#pragma once

#include "base/result.h"
#include "project/arrays/buffer_store.h"
#include "surfacing/pipeline/surfacing_state.h"

#include <string>

namespace ductus {

/// The bytes of a .ductus file; equal input, equal bytes. \a givenProxy as it was given, or nothing.
Result<Bytes> projectBytes(const SurfacingState &state, const std::optional<TriangleMesh> &givenProxy,
                           const std::vector<Scribble> &scribbles, const std::string &name);

} // namespace ductus
