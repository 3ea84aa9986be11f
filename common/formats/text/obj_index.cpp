#include "formats/text/obj_index.h"

#include "formats/text/number_text.h"

namespace ductus {

Result<int> readObjIndex(std::string_view word, std::int64_t vertexCount, const TextLines &lines)
{
    const std::string_view vertex = word.substr(0, word.find('/'));
    std::int64_t index = 0;
    const NumberFault fault = readInteger(vertex, index);
    if (fault != NumberFault::None)
        return lines.error(ErrorCode::Malformed, "the vertex index " + describeFault(fault, vertex),
                           "Correct this line or export the file again");
    if (index == 0)
        return lines.error(ErrorCode::Malformed, "the vertex index is 0, but OBJ counts from 1",
                           "Correct this line or export the file again");
    const bool inRange = index > 0 ? index <= vertexCount : index >= -vertexCount;
    if (!inRange)
        return lines.error(ErrorCode::Malformed,
                           "the vertex index " + std::to_string(index) + " is out of range: " +
                               std::to_string(vertexCount) + " vertices come before this line",
                           "Correct this line or export the file again");
    return int(index > 0 ? index - 1 : vertexCount + index);
}

} // namespace ductus
