// Errors of readers that know a place within a file, told with the file.
#pragma once

#include "base/error.h"

#include <filesystem>

namespace ductus {

/// \a error with \a path before its place, unless the place names the file already.
inline Error placedIn(Error error, const std::filesystem::path &path)
{
    if (error.place.find(path.filename().string()) == std::string::npos)
        error.place = path.string() + (error.place.empty() ? "" : ": " + error.place);
    return error;
}

} // namespace ductus
