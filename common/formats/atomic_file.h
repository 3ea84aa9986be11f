// Writing files so that the reader of the path sees the old content or the new one, never a part.
#pragma once

#include "base/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace ductus {

/// Writes \a bytes to a temporary file in the same folder, flushes it to disk and renames it over \a path. On
/// failure the temporary is removed and the Error names the path and the system's reason.
/// A symbolic link stays a link: the file it points to is replaced, and keeps its permission bits. Targets
/// that exist and are no regular file (a folder, a device) are refused. \a attempted: "Writing the mesh".
Result<void> writeFileAtomically(const std::filesystem::path &path, std::span<const std::byte> bytes,
                                 const std::string &attempted);

/// Whole file in memory. Says apart: missing, a directory, no permission, larger than \a maxBytes.
Result<std::string> readWholeFile(const std::filesystem::path &path, std::size_t maxBytes,
                                  const std::string &attempted);

/// The Error for a system error number \a systemError (errno) met with \a path; \a fallback is the code for
/// reasons that have none of their own (ReadFailed or WriteFailed).
Error systemErrorFor(int systemError, const std::filesystem::path &path, const std::string &attempted,
                     ErrorCode fallback);

} // namespace ductus
