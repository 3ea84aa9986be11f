// Vertex references of OBJ records ("7", "-1", "7/3/2"), the same for lines and faces.
#pragma once

#include "formats/text/text_lines.h"

namespace ductus {

/// The 0-based vertex index \a word refers to: positive counts from the first vertex, negative back from the
/// last one read so far. Texture and normal indices after '/' are not looked at. The Error tells what is out
/// of range.
Result<int> readObjIndex(std::string_view word, std::int64_t vertexCount, const TextLines &lines);

} // namespace ductus
