// SketchSurfaceDocument to and from its JSON and arrays. Fields:
// resources/schemas/sketch_surface.schema.json.
#pragma once

#include "project/arrays/array_loader.h"
#include "project/arrays/buffer_packer.h"
#include "project/sketch_surface_document.h"
#include "project/uuid.h"

namespace ductus {

/// Refuses what a reader would refuse (InvalidArgument, place = the field): numbers that are not finite,
/// repeated ids, channels of another length than their stroke, triangles of missing vertices.
Result<void> checkSketchSurface(const SketchSurfaceDocument &document, const std::string &place);

/// The JSON of a checked document; its arrays are added to \a packer, which this finishes.
OrderedJson sketchSurfaceToJson(const SketchSurfaceDocument &document, const Uuid &id, BufferPacker &packer);

/// Reads version sketchSurfaceVersion; what is wrong is told through \a reader (ask failed() afterwards).
SketchSurfaceDocument sketchSurfaceFromJson(const JsonReader &reader, ArrayLoader &arrays);

} // namespace ductus
