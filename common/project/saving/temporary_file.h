// A file beside its target that becomes it by renaming. While it is being written it is held by flock(), so
// that others can tell a file in use from what a killed program left behind.
#pragma once

#include "base/result.h"

#include <filesystem>
#include <span>

namespace ductus {

class TemporaryFile
{
public:
    /// An empty file in the folder of \a target.
    static Result<TemporaryFile> createBeside(const std::filesystem::path &target);

    /// Removes the file unless it was renamed.
    ~TemporaryFile();
    TemporaryFile(TemporaryFile &&other) noexcept;
    TemporaryFile &operator=(TemporaryFile &&) = delete;

    const std::filesystem::path &path() const { return mPath; }

    /// Writes all of \a bytes and flushes them to the disk.
    Result<void> write(std::span<const std::byte> bytes);

    /// Gives the file the permissions of \a other.
    void copyPermissions(const std::filesystem::path &other);

    /// Takes the place of \a target in one step and flushes the folder.
    Result<void> renameTo(const std::filesystem::path &target);

private:
    TemporaryFile(std::filesystem::path path, int descriptor)
        : mPath(std::move(path)), mDescriptor(descriptor)
    {
    }

    std::filesystem::path mPath;
    int mDescriptor = -1;
};

/// A name for a temporary beside \a target that was not used before in this process.
std::filesystem::path temporaryName(const std::filesystem::path &target);

/// Removes what killed saves of \a target left in its folder; files another program is writing stay.
void removeLeftovers(const std::filesystem::path &target);

} // namespace ductus
