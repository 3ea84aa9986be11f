#include "project/saving/temporary_file.h"

#include "base/sha256.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>

namespace ductus {

namespace fs = std::filesystem;

namespace {

constexpr char attempted[] = "Saving the project";

Error systemError(const fs::path &path, int number)
{
    const bool forbidden = number == EACCES || number == EPERM || number == EROFS;
    const ErrorCode code = forbidden          ? ErrorCode::PermissionDenied
                           : number == ENOENT ? ErrorCode::FileNotFound
                                              : ErrorCode::WriteFailed;
    const char *remedy = number == ENOSPC || number == EDQUOT ? "Free some space or save to another place"
                         : forbidden                          ? "Save to another place"
                                                              : "";
    return {code, attempted, std::strerror(number), remedy, path.string()};
}

fs::path folderOf(const fs::path &target)
{
    return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

// Names of any length and script come out the same length, so that a long name stays within the system's
// limit.
std::string namePrefix(const fs::path &target)
{
    const std::string name = target.filename().string();
    return ".ductus-" + sha256Hex(std::as_bytes(std::span(name))).substr(0, 16) + "-";
}

void flushFolder(const fs::path &folder)
{
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return; // the file itself is flushed; a folder that cannot be opened cannot be flushed
    ::fsync(descriptor);
    ::close(descriptor);
}

// True where the file is still in its folder and ours: nobody took it for a leftover before we could lock it.
bool lockNew(int descriptor)
{
    if (::flock(descriptor, LOCK_EX) != 0)
        return errno == ENOLCK || errno == EOPNOTSUPP || errno == ENOSYS || errno == EINVAL; // no locks here
    struct stat status = {};
    return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

} // namespace

fs::path temporaryName(const fs::path &target)
{
    static std::atomic<unsigned> counter = 0;
    return folderOf(target) /
           (namePrefix(target) + std::to_string(::getpid()) + "-" + std::to_string(++counter) + ".tmp");
}

Result<TemporaryFile> TemporaryFile::createBeside(const fs::path &target)
{
    for (int attempt = 0; attempt < 1000; ++attempt) {
        const fs::path path = temporaryName(target);
        const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor < 0 && errno == EEXIST)
            continue;
        if (descriptor < 0)
            return systemError(target, errno);
        if (lockNew(descriptor))
            return TemporaryFile(path, descriptor);
        ::close(descriptor);
    }
    return systemError(target, EEXIST);
}

TemporaryFile::TemporaryFile(TemporaryFile &&other) noexcept
    : mPath(std::move(other.mPath)), mDescriptor(std::exchange(other.mDescriptor, -1))
{
    other.mPath.clear();
}

TemporaryFile::~TemporaryFile()
{
    if (!mPath.empty())
        ::unlink(mPath.c_str());
    if (mDescriptor >= 0)
        ::close(mDescriptor);
}

Result<void> TemporaryFile::write(std::span<const std::byte> bytes)
{
    constexpr std::size_t chunk = 16 << 20;
    while (!bytes.empty()) {
        const ssize_t count = ::write(mDescriptor, bytes.data(), std::min(bytes.size(), chunk));
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            return systemError(mPath, errno);
        bytes = bytes.subspan(std::size_t(count));
    }
    if (::fsync(mDescriptor) != 0)
        return systemError(mPath, errno);
    return {};
}

void TemporaryFile::copyPermissions(const fs::path &other)
{
    struct stat status = {};
    if (::stat(other.c_str(), &status) == 0)
        static_cast<void>(
            ::fchmod(mDescriptor, status.st_mode & 07777)); // a disk without permissions is no failure
}

Result<void> TemporaryFile::renameTo(const fs::path &target)
{
    if (::rename(mPath.c_str(), target.c_str()) != 0)
        return systemError(target, errno);
    mPath.clear();
    flushFolder(folderOf(target));
    return {};
}

void removeLeftovers(const fs::path &target)
{
    const std::string prefix = namePrefix(target);
    std::error_code ignored; // a folder that cannot be listed: the save itself will tell
    for (fs::directory_iterator file(folderOf(target), ignored), end; !ignored && file != end;
         file.increment(ignored)) {
        const std::string name = file->path().filename().string();
        if (!name.starts_with(prefix) || !name.ends_with(".tmp"))
            continue;
        const int descriptor = ::open(file->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
        if (descriptor < 0)
            continue;
        if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
            ::unlink(file->path().c_str());
        ::close(descriptor);
    }
}

} // namespace ductus
