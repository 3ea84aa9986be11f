// The files one command writes: all of them appear, or none. A mesh without the report that was asked for
// beside it, or a report about a mesh that could not be written, would be half a result.
//
//     OutputFiles files;
//     if (Result<void> added = files.add(reportPath, bytes, "Writing the report"); !added) return ...;
//     if (Result<void> added = files.add(meshPath, bytes, "Writing the mesh"); !added) return ...;
//     return files.commit();
#pragma once

#include "base/result.h"
#include "project/saving/temporary_file.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace ductus {

class OutputFiles
{
public:
    /// Writes \a bytes to a temporary file beside \a path and flushes it. Nothing is visible under \a path
    /// before commit(); without it the temporaries are removed by the destructor. A symbolic link stays one:
    /// what it points to is replaced. \a attempted: "Writing the report". Errors name \a path.
    Result<void> add(const std::filesystem::path &path, std::span<const std::byte> bytes,
                     const std::string &attempted);

    /// Renames all temporaries into place, in the order added. Where one cannot be, those before it that did
    /// not exist before are removed again; files that were replaced keep their new content.
    Result<void> commit();

private:
    struct Pending
    {
        TemporaryFile file;
        std::filesystem::path target;
        std::filesystem::path path;
        std::string attempted;
    };

    std::vector<Pending> mPending;
};

/// Tells before the work starts what would make writing \a path fail after it: the folder is missing or may
/// not be written to, the path is a folder or a device, or an existing file is write-protected.
Result<void> checkWritable(const std::filesystem::path &path, const std::string &attempted);

/// True if both name the same file, existing or not, whichever way they are spelled.
bool isSameFile(const std::filesystem::path &a, const std::filesystem::path &b);

} // namespace ductus
