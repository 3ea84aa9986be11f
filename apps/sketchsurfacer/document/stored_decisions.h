// The user's decisions in the settings of a stored sketch: parameters, symmetry, tightness, scribbles. What
// the first version of the format has no field for stands in further members of "settings", as JSON.
#pragma once

#include "project/sketch_surface_document.h"
#include "sketchsurfacer/document/sketch_content.h"

namespace ductus {

void writeDecisions(const SketchContent &content, SurfacingSettings &settings);

/// Malformed if a member is not what writeDecisions writes; \a content is then half filled and to be thrown
/// away.
Result<void> readDecisions(const SurfacingSettings &settings, SketchContent &content);

} // namespace ductus
