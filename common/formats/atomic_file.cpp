#include "formats/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <limits>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace ductus {

namespace fs = std::filesystem;

namespace {

/// Closes on every way out; close() says whether the data reached the file system.
class Descriptor
{
public:
    explicit Descriptor(int number) : mNumber(number) {}
    ~Descriptor()
    {
        if (mNumber >= 0)
            ::close(mNumber);
    }
    Descriptor(const Descriptor &) = delete;
    Descriptor &operator=(const Descriptor &) = delete;

    int number() const { return mNumber; }
    bool isOpen() const { return mNumber >= 0; }
    int close()
    {
        const int result = ::close(mNumber);
        mNumber = -1;
        return result;
    }

private:
    int mNumber;
};

/// The file a chain of links ends at, so that a save does not turn the user's link into a file.
fs::path linkTarget(const fs::path &path)
{
    fs::path target = path;
    std::error_code error;
    for (int hops = 0; hops < 40 && fs::is_symlink(target, error); ++hops) {
        const fs::path next = fs::read_symlink(target, error);
        if (error)
            break;
        target = next.is_absolute() ? next : target.parent_path() / next;
    }
    return target;
}

/// Creates a file nobody else has, beside the target: a rename is atomic only within one file system.
/// Its short fixed name fits where a long target name plus a suffix would not.
int createBeside(const fs::path &folder, fs::path &created)
{
    static std::atomic<std::uint32_t> counter{0};
    for (int attempt = 0; attempt < 1000; ++attempt) {
        created =
            folder / (".ductus-" + std::to_string(::getpid()) + "-" + std::to_string(++counter) + ".tmp");
        const int number = ::open(created.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (number >= 0 || errno != EEXIST)
            return number;
    }
    return -1;
}

bool writeAll(int file, std::span<const std::byte> bytes)
{
    constexpr std::size_t largestWrite = std::size_t(1) << 30;
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), std::min(bytes.size(), largestWrite));
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return false;
        bytes = bytes.subspan(std::size_t(written));
    }
    return true;
}

} // namespace

Error systemErrorFor(int systemError, const fs::path &path, const std::string &attempted, ErrorCode fallback)
{
    const std::string reason = std::generic_category().message(systemError);
    const std::string place = path.string();
    const bool writing = fallback == ErrorCode::WriteFailed;
    switch (systemError) {
    case ENOENT:
    case ENOTDIR:
        return {ErrorCode::FileNotFound, attempted,
                writing ? "the folder does not exist (" + reason + ")"
                        : "there is no such file (" + reason + ")",
                writing ? "Create the folder or choose another one" : "Check the path", place};
    case EACCES:
    case EPERM:
    case EROFS:
        return {ErrorCode::PermissionDenied, attempted, "the system does not allow it (" + reason + ")",
                writing ? "Choose a folder you may write to" : "Ask for the right to read this file", place};
    case EISDIR:
        return {ErrorCode::NotAFile, attempted, "this is a folder, not a file", "Give the path of a file",
                place};
    case ENOSPC:
    case EDQUOT:
        return {fallback, attempted, "the disk is full (" + reason + ")", "Free some space and try again",
                place};
    case ENAMETOOLONG:
        return {fallback, attempted, "the name is too long (" + reason + ")", "Choose a shorter name", place};
    default:
        return {fallback, attempted, reason, "", place};
    }
}

Result<void> writeFileAtomically(const fs::path &path, std::span<const std::byte> bytes,
                                 const std::string &attempted)
{
    const auto failed = [&](int reason) {
        return systemErrorFor(reason, path, attempted, ErrorCode::WriteFailed);
    };
    if (path.filename().empty() || path.filename() == "." || path.filename() == "..")
        return Error{ErrorCode::NotAFile, attempted, "the path names no file", "Give the path of a file",
                     path.string()};
    const fs::path target = linkTarget(path);
    struct stat existing = {};
    const bool exists = ::stat(target.c_str(), &existing) == 0;
    if (exists && S_ISDIR(existing.st_mode))
        return failed(EISDIR);
    if (exists && !S_ISREG(existing.st_mode))
        return Error{ErrorCode::NotAFile, attempted, "this is a device or a pipe, not a file",
                     "Give the path of a file", path.string()};

    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    fs::path temporary;
    Descriptor file(createBeside(folder, temporary));
    if (!file.isOpen())
        return failed(errno);
    bool done = writeAll(file.number(), bytes);
    if (done && exists)
        done = ::fchmod(file.number(), existing.st_mode & 07777) == 0;
    // The data must be on disk before the name points to it, or a power cut leaves an empty file.
    done = done && ::fsync(file.number()) == 0;
    done = done && file.close() == 0;
    done = done && ::rename(temporary.c_str(), target.c_str()) == 0;
    if (!done) {
        const int reason = errno;
        ::unlink(temporary.c_str());
        return failed(reason);
    }
    // Makes the rename itself durable. Some file systems cannot sync a folder; the file is complete either
    // way.
    const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.isOpen())
        ::fsync(opened.number());
    return {};
}

Result<std::string> readWholeFile(const fs::path &path, std::size_t maxBytes, const std::string &attempted)
{
    const auto failed = [&](int reason) {
        return systemErrorFor(reason, path, attempted, ErrorCode::ReadFailed);
    };
    const auto tooLarge = [&] {
        return Error{ErrorCode::TooLarge, attempted,
                     "the file is larger than the " + std::to_string(maxBytes >> 20) +
                         " MB this reader takes",
                     "Export it in a smaller or simpler form", path.string()};
    };
    // O_NONBLOCK: opening a pipe nobody writes to must not hang; it means nothing for regular files.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!file.isOpen())
        return failed(errno);
    struct stat status = {};
    if (::fstat(file.number(), &status) != 0)
        return failed(errno);
    if (S_ISDIR(status.st_mode))
        return failed(EISDIR);
    if (!S_ISREG(status.st_mode))
        return Error{ErrorCode::NotAFile, attempted, "this is a device or a pipe, not a file",
                     "Give the path of a file", path.string()};
    if (std::uint64_t(status.st_size) > maxBytes)
        return tooLarge();

    // The size is only a hint: another program may be writing, and files below /proc say 0.
    std::string text(std::size_t(status.st_size), '\0');
    std::size_t filled = 0;
    for (;;) {
        if (filled == text.size())
            text.resize(filled + 65536);
        const ssize_t got = ::read(file.number(), text.data() + filled, text.size() - filled);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return failed(errno);
        if (got == 0)
            break;
        filled += std::size_t(got);
        if (filled > maxBytes)
            return tooLarge();
    }
    text.resize(filled);
    return text;
}

} // namespace ductus
