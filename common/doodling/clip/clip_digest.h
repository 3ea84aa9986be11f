// Which clip it is, whatever it is called: the hash of its bytes. A folder of pictures is hashed as the names
// and bytes of its files.
#pragma once

#include "base/job_control.h"
#include "base/result.h"

#include <filesystem>
#include <string>

namespace ductus {

/// 64 lower-case hex digits. FileNotFound, PermissionDenied, ReadFailed.
Result<std::string> clipDigest(const std::filesystem::path &path, const JobControl &control);

} // namespace ductus
