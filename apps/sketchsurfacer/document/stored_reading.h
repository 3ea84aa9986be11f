// A chosen reading of a sketch (surfacing/pipeline/ambiguity.h) to and from what the project file keeps of
// it: its regions at the points of the proxy, and their models. The proxy itself is made again.
#pragma once

#include "project/sketch_surface_document.h"
#include "sketchsurfacer/document/sketch_content.h"

namespace ductus {

/// Regions of \a labelled without any scribbles; it must have labels. In input coordinates.
StoredReading storedReading(const SurfacingState &labelled);

/// \a prepared labelled as \a reading has it. Its proxy may be another than the one the reading was made on:
/// a vertex takes the label of the nearest point. Fails with Malformed for a reading without points.
Result<SurfacingState> withReading(const SurfacingState &prepared, const StoredReading &reading,
                                   const JobControl &control);

/// What \a content's reading is to be surfaced from: as it was chosen, or made again of what the file kept.
/// \a content must have one.
Result<std::shared_ptr<const SurfacingState>> labelledReading(const SketchContent &content,
                                                              const JobControl &control);

} // namespace ductus
