#include "cli/output_files.h"

#include <unistd.h>

namespace ductus {

namespace fs = std::filesystem;

namespace {

/// The file a chain of links ends at; links that go in circles are left for the system to refuse.
fs::path linkTarget(const fs::path &path)
{
    fs::path target = path;
    std::error_code ec;
    for (int hops = 0; hops < 40 && fs::is_symlink(target, ec); ++hops) {
        const fs::path next = fs::read_symlink(target, ec);
        if (ec)
            break;
        target = next.is_absolute() ? next : target.parent_path() / next;
    }
    return target;
}

fs::path folderOf(const fs::path &target)
{
    return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

} // namespace

Result<void> OutputFiles::add(const fs::path &path, std::span<const std::byte> bytes,
                              const std::string &attempted)
{
    if (Result<void> writable = checkWritable(path, attempted); !writable)
        return writable;
    const fs::path target = linkTarget(path);
    // The user knows the path, not the name of the temporary.
    const auto told = [&](Error error) {
        error.attempted = attempted;
        error.place = path.string();
        return error;
    };
    Result<TemporaryFile> file = TemporaryFile::createBeside(target);
    if (!file)
        return told(file.error());
    if (Result<void> written = file->write(bytes); !written)
        return told(written.error());
    file->copyPermissions(target);
    mPending.push_back({std::move(*file), target, path, attempted});
    return {};
}

Result<void> OutputFiles::commit()
{
    std::vector<fs::path> created;
    for (Pending &pending : mPending) {
        std::error_code ec;
        const bool isNew = !fs::exists(pending.target, ec);
        if (Result<void> renamed = pending.file.renameTo(pending.target); !renamed) {
            for (const fs::path &path : created)
                fs::remove(path, ec); // what cannot be removed is complete all the same
            Error error = renamed.error();
            error.attempted = pending.attempted;
            error.place = pending.path.string();
            mPending.clear();
            return error;
        }
        if (isNew)
            created.push_back(pending.target);
    }
    mPending.clear();
    return {};
}

Result<void> checkWritable(const fs::path &path, const std::string &attempted)
{
    const auto refused = [&](ErrorCode code, const char *problem, const char *remedy) {
        return Error{code, attempted, problem, remedy, path.string()};
    };
    std::error_code ec;
    const fs::path target = linkTarget(path);
    const fs::file_status status = fs::status(target, ec);
    if (fs::is_directory(status) || target.filename().empty())
        return refused(ErrorCode::NotAFile, "this is a folder", "Choose a file name");
    if (fs::exists(status) && !fs::is_regular_file(status))
        return refused(ErrorCode::NotAFile, "this is a device or a pipe, not a file", "Choose a file name");
    const fs::path folder = folderOf(target);
    if (!fs::is_directory(folder, ec))
        return ec == std::errc::permission_denied
                   ? refused(ErrorCode::PermissionDenied, "the folder may not be looked into",
                             "Choose another place")
                   : refused(ErrorCode::FileNotFound, "the folder does not exist",
                             "Create it, or choose another place");
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        return refused(ErrorCode::PermissionDenied, "the folder may not be written to",
                       "Choose another place");
    // Renaming over it would succeed, yet whoever protected the file meant to keep it.
    if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0)
        return refused(ErrorCode::PermissionDenied, "the file exists and is write-protected",
                       "Lift the protection, or choose another name");
    return {};
}

bool isSameFile(const fs::path &a, const fs::path &b)
{
    std::error_code ec;
    if (fs::exists(a, ec) && fs::exists(b, ec))
        return fs::equivalent(a, b, ec);
    const auto spelled = [](const fs::path &path) {
        std::error_code failed;
        const fs::path target = linkTarget(path);
        const fs::path full = fs::weakly_canonical(target, failed);
        return failed               ? target.lexically_normal()
               : full.is_absolute() ? full
                                    : fs::absolute(full, failed).lexically_normal();
    };
    return spelled(a) == spelled(b);
}

} // namespace ductus
