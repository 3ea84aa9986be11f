// Names of container entries: always relative, inside the container, the same text on every system.
#pragma once

#include <string>
#include <string_view>

namespace ductus {

/// True if \a text is well-formed UTF-8 (no overlong forms, no surrogates, nothing above U+10FFFF).
bool isValidUtf8(std::string_view text);

/// What is wrong with \a name as the name of an entry, or an empty string if nothing is. Refused: empty or
/// overlong names, absolute ones, "." and ".." and empty components, backslashes, colons, control characters,
/// broken UTF-8. A name of a folder (ending in '/') is allowed.
std::string entryNameProblem(std::string_view name);

/// True for 64 lower-case hex digits.
bool isSha256(std::string_view text);

/// "buffers/<sha256>.bin"
std::string bufferEntryName(std::string_view sha256);

/// The hash in "buffers/<sha256>.bin", empty for other names.
std::string_view sha256OfBufferEntry(std::string_view name);

} // namespace ductus
