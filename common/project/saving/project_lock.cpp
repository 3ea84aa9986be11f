#include "project/saving/project_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>

namespace ductus {

namespace fs = std::filesystem;

namespace {

constexpr char attempted[] = "Locking the project";
constexpr char remedy[] = "Close it there, or open it read-only";

Error lockError(ErrorCode code, std::string problem, const fs::path &file, std::string what = {})
{
    return {code, attempted, std::move(problem), std::move(what), file.string()};
}

// Closes the file unless it is handed on.
struct Descriptor
{
    int number = -1;
    ~Descriptor()
    {
        if (number >= 0)
            ::close(number);
    }
};

enum class Hold { Ours, Theirs, Unknown };

// Unknown: this file system has no locks.
Hold tryHold(int descriptor)
{
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
        return Hold::Ours;
    return errno == EWOULDBLOCK ? Hold::Theirs : Hold::Unknown;
}

// Nobody removed or replaced the file between opening and locking it.
bool isStillInPlace(int descriptor, const fs::path &file)
{
    struct stat mine = {};
    struct stat there = {};
    return ::fstat(descriptor, &mine) == 0 && ::lstat(file.c_str(), &there) == 0 &&
           mine.st_ino == there.st_ino && mine.st_dev == there.st_dev;
}

// Nothing where the file is empty or torn: its writer was killed before it had the lock.
std::optional<LockOwner> readOwner(int descriptor)
{
    std::array<char, 4096> buffer = {};
    const ssize_t count = ::pread(descriptor, buffer.data(), buffer.size(), 0);
    if (count <= 0)
        return std::nullopt;
    Result<LockOwner> owner = LockOwner::parse(std::string_view(buffer.data(), std::size_t(count)));
    return owner ? std::optional<LockOwner>(std::move(*owner)) : std::nullopt;
}

Result<void> writeOwner(int descriptor, const LockOwner &owner, const fs::path &file)
{
    const std::string text = owner.toText();
    if (::ftruncate(descriptor, 0) != 0 ||
        ::pwrite(descriptor, text.data(), text.size(), 0) != ssize_t(text.size()))
        return lockError(ErrorCode::WriteFailed, std::strerror(errno), file);
    return {};
}

// Who stands in the way of taking the lock, if anybody.
std::optional<std::string> obstacle(Hold hold, const std::optional<LockOwner> &owner, const LockOwner &self)
{
    if (hold == Hold::Theirs)
        return owner ? owner->description() : "another program that just opened it";
    if (!owner)
        return std::nullopt;
    if (owner->host != self.host) // locks of another host may not reach this one
        return owner->description();
    if (hold == Hold::Unknown && owner->mayBeAlive() && owner->pid != self.pid)
        return owner->description();
    return std::nullopt;
}

Result<int> openLockFile(const fs::path &file)
{
    const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (descriptor >= 0)
        return descriptor;
    const int number = errno;
    const bool forbidden = number == EACCES || number == EPERM || number == EROFS;
    if (forbidden) { // another user's lock can be read, if not written
        const Descriptor other{::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW)};
        if (other.number >= 0 && tryHold(other.number) == Hold::Theirs) {
            const std::optional<LockOwner> owner = readOwner(other.number);
            return lockError(ErrorCode::Locked,
                             "the project is open in " +
                                 (owner ? owner->description() : std::string("another program")),
                             file, remedy);
        }
    }
    return lockError(forbidden          ? ErrorCode::PermissionDenied
                     : number == ENOENT ? ErrorCode::FileNotFound
                                        : ErrorCode::WriteFailed,
                     std::strerror(number), file,
                     forbidden ? "Open it read-only or save a copy elsewhere" : "");
}

} // namespace

fs::path lockPath(const fs::path &path)
{
    std::error_code error;
    fs::path file = path;
    if (fs::is_symlink(fs::symlink_status(path, error))) {
        if (const fs::path target = fs::weakly_canonical(path, error); !error)
            file = target;
    }
    file += ".lock";
    return file;
}

Result<ProjectLock> ProjectLock::acquire(const fs::path &path, const std::string &application)
{
    const fs::path file = lockPath(path);
    const LockOwner self = LockOwner::self(application);
    for (int attempt = 0; attempt < 100; ++attempt) {
        const Result<int> opened = openLockFile(file);
        if (!opened)
            return opened.error();
        Descriptor descriptor{*opened};
        const Hold hold = tryHold(descriptor.number);
        if (!isStillInPlace(descriptor.number, file))
            continue;
        if (const std::optional<std::string> who = obstacle(hold, readOwner(descriptor.number), self))
            return lockError(ErrorCode::Locked, "the project is open in " + *who, file, remedy);
        if (Result<void> written = writeOwner(descriptor.number, self, file); !written)
            return written.error();
        return ProjectLock(file, std::exchange(descriptor.number, -1));
    }
    return lockError(ErrorCode::Locked, "another program takes and leaves the lock again and again", file,
                     remedy);
}

Result<void> ProjectLock::breakLock(const fs::path &path)
{
    const fs::path file = lockPath(path);
    const Descriptor descriptor{::open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW)};
    if (descriptor.number < 0)
        return errno == ENOENT ? Result<void>()
                               : lockError(ErrorCode::PermissionDenied, std::strerror(errno), file);
    if (tryHold(descriptor.number) == Hold::Theirs) {
        const std::optional<LockOwner> owner = readOwner(descriptor.number);
        return lockError(ErrorCode::Locked,
                         "the project is open in " +
                             (owner ? owner->description() : std::string("another program")),
                         file, remedy);
    }
    if (::unlink(file.c_str()) != 0)
        return lockError(ErrorCode::WriteFailed, std::strerror(errno), file);
    return {};
}

ProjectLock::ProjectLock(ProjectLock &&other) noexcept
    : mFile(std::move(other.mFile)), mDescriptor(std::exchange(other.mDescriptor, -1))
{
}

ProjectLock::~ProjectLock()
{
    if (mDescriptor < 0)
        return;
    if (isStillInPlace(mDescriptor, mFile)) // never somebody else's
        ::unlink(mFile.c_str());
    ::close(mDescriptor);
}

} // namespace ductus
