#include "formats/film/output_place.h"

#include "formats/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace ductus {

namespace fs = std::filesystem;

namespace {

constexpr char attempted[] = "Writing the film";

Error failed(int reason, const fs::path &path)
{
    return systemErrorFor(reason, path, attempted, ErrorCode::WriteFailed);
}

fs::path unusedName(const fs::path &folder, const std::string &extension)
{
    static std::atomic<unsigned> counter{0};
    return folder /
           (".ductus-" + std::to_string(::getpid()) + "-film" + std::to_string(++counter) + extension);
}

bool isNumberedPicture(const std::string &name)
{
    int number = 0;
    return std::sscanf(name.c_str(), "frame-%d.png", &number) == 1 && name == numberedPicture(number);
}

Result<void> checkReplaceable(const fs::path &folder)
{
    std::error_code error;
    if (!fs::exists(folder, error))
        return {};
    if (!fs::is_directory(folder, error))
        return Error{ErrorCode::WriteFailed, attempted, "there is a file with the name of the folder",
                     "Choose another name", folder.string()};
    for (const fs::directory_entry &entry : fs::directory_iterator(folder, error))
        if (!isNumberedPicture(entry.path().filename().string()))
            return Error{ErrorCode::WriteFailed, attempted,
                         "the folder holds other files (" + entry.path().filename().string() + ")",
                         "Choose an empty or a new folder for the pictures", folder.string()};
    return error ? Result<void>(failed(error.value(), folder)) : Result<void>();
}

void flush(const fs::path &path)
{
    const int opened = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (opened < 0)
        return; // what cannot be opened for reading is complete all the same
    ::fsync(opened);
    ::close(opened);
}

} // namespace

OutputPlace::OutputPlace(fs::path path, fs::path target, Kind kind)
    : mPath(std::move(path)), mTarget(std::move(target)), mKind(kind)
{
}

OutputPlace::OutputPlace(OutputPlace &&other) noexcept
    : mPath(std::exchange(other.mPath, {})), mTarget(std::move(other.mTarget)), mKind(other.mKind)
{
}

OutputPlace::~OutputPlace()
{
    std::error_code ignored; // nothing more can be done about a temporary that cannot be removed
    if (!mPath.empty())
        fs::remove_all(mPath, ignored);
}

Result<OutputPlace> OutputPlace::beside(const fs::path &wanted, Kind kind)
{
    std::error_code error;
    fs::path target = wanted;
    if (!target.has_filename()) // "folder/"
        target = target.parent_path();
    if (target.filename().empty() || target.filename() == "." || target.filename() == "..")
        return Error{ErrorCode::NotAFile, attempted, "the path names nothing that can be written",
                     "Give the film a name", wanted.string()};
    if (fs::is_symlink(target, error)) // a link stays one: what it points to is replaced
        if (const fs::path real = fs::canonical(target, error); !error)
            target = real;
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (kind == Kind::Folder) {
        if (const Result<void> free = checkReplaceable(target); !free)
            return free.error();
        fs::path made = unusedName(folder, "");
        if (!fs::create_directory(made, error))
            return failed(error ? error.value() : EEXIST, target);
        return OutputPlace(std::move(made), std::move(target), kind);
    }
    if (fs::is_directory(target, error))
        return failed(EISDIR, target);
    if (fs::exists(target, error) && !fs::is_regular_file(target, error))
        return Error{ErrorCode::NotAFile, attempted, "this is a device or a pipe, not a file",
                     "Give the path of a file", target.string()};
    if (fs::exists(target, error) && ::access(target.c_str(), W_OK) != 0)
        return failed(errno, target);
    fs::path made = unusedName(folder, target.extension().string());
    const int opened = ::open(made.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (opened < 0)
        return failed(errno, target);
    ::close(opened);
    return OutputPlace(std::move(made), std::move(target), kind);
}

Result<void> OutputPlace::commit()
{
    std::error_code error;
    if (mKind == Kind::Folder) {
        // Again: minutes have passed since beside() looked.
        if (const Result<void> free = checkReplaceable(mTarget); !free)
            return free;
        fs::remove_all(mTarget, error);
        if (error)
            return failed(error.value(), mTarget);
    }
    flush(mPath);
    if (::rename(mPath.c_str(), mTarget.c_str()) != 0)
        return failed(errno, mTarget);
    mPath.clear();
    flush(mTarget.has_parent_path() ? mTarget.parent_path() : fs::path("."));
    return {};
}

std::string numberedPicture(int number)
{
    char name[32];
    std::snprintf(name, sizeof name, "frame-%05d.png", number);
    return name;
}

} // namespace ductus
