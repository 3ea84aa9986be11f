// The tubes of skeletal strokes, put beside the surface.
#pragma once

#include "surfacing/pipeline/surfacing_state.h"

namespace ductus {

/// Each tube is a region of its own, after those of the surface.
void appendTubes(const PreparedSketch &sketch, const SkeletalOptions &options, SurfaceResult &result);

/// The same, so that region numbers of preview and result agree.
void appendTubes(const PreparedSketch &sketch, const SkeletalOptions &options, LabelPreview &preview);

} // namespace ductus
