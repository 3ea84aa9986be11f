// A file or folder that becomes its target by renaming, or vanishes.
#pragma once

#include "base/result.h"

#include <filesystem>

namespace ductus {

class OutputPlace
{
public:
    enum class Kind { File, Folder };

    /// Makes the folder, or finds a name for the file and tries that one can be written, beside \a target.
    static Result<OutputPlace> beside(const std::filesystem::path &target, Kind kind);

    OutputPlace(OutputPlace &&other) noexcept;
    OutputPlace &operator=(OutputPlace &&) = delete;
    /// Removes what is at path() unless it was committed.
    ~OutputPlace();

    const std::filesystem::path &path() const { return mPath; }

    /// Flushes and renames. A file replaces an older one; a folder an empty one, or one that only holds
    /// pictures named as in numberedPicture().
    Result<void> commit();

private:
    OutputPlace(std::filesystem::path path, std::filesystem::path target, Kind kind);

    std::filesystem::path mPath; // empty once committed
    std::filesystem::path mTarget;
    Kind mKind;
};

/// "frame-00001.png" for \a number 1.
std::string numberedPicture(int number);

} // namespace ductus
