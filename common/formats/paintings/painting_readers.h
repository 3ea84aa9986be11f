// One reader a format; painting_file.h chooses.
#pragma once

#include "formats/archive/byte_source.h"
#include "formats/painting_file.h"

namespace ductus {

/// \a qbin may be null if the data file is missing: then only a scene without drawings can be read,
/// FileNotFound else. State.json (the state of Quill's tools) is not needed.
Result<PaintingFile> readQuill(ByteSource &json, ByteSource *qbin, const PaintingReadOptions &options,
                               const JobControl &control);

/// One layer of strokes a layer of the sketch, right-handed, in decimetres; brushes by their GUID, widths by
/// pressure. \a metadataJson may be null.
Result<PaintingFile> readTilt(ByteSource &sketch, ByteSource *metadataJson,
                              const PaintingReadOptions &options, const JobControl &control);

} // namespace ductus
