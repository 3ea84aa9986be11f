// Quill.json as plain structs: the layer tree with the places of its data in Quill.qbin. quill-and-tilt.md
// section 3.
#pragma once

#include "formats/archive/byte_source.h"
#include "formats/painting_file.h"

namespace ductus {

struct QuillLayer
{
    PaintingFileLayer layer;                   // drawings and picture not yet filled; frames as in the file
    std::string type;                          // "Paint", "Sound", ...
    std::vector<std::uint64_t> drawingOffsets; // in Quill.qbin, by drawing index
    std::optional<std::uint64_t> dataOffset;   // of the picture
};

struct QuillScene
{
    PaintingFile painting;          // title, rate, background, notes; no layers
    std::vector<QuillLayer> layers; // the root first, parents before children
};

/// Reads the text as a stream: memory is taken for one layer's text at a time and for the result.
/// Malformed with line or layer for what is no JSON or no Quill scene; Unsupported for scenes of Quill 1.3
/// and before whose transforms are matrices.
Result<QuillScene> readQuillScene(ByteSource &json, const JobControl &control);

} // namespace ductus
