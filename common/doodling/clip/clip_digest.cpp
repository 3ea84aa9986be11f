#include "doodling/clip/clip_digest.h"

#include "base/sha256.h"
#include "doodling/clip/open_clip.h"
#include "formats/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <vector>

namespace ductus {

namespace {

namespace fs = std::filesystem;

constexpr char attempted[] = "Looking which clip it is";
constexpr std::size_t pieceBytes = 1u << 20;

Result<void> addFile(const fs::path &path, Sha256 &hash, const JobControl &control)
{
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return systemErrorFor(errno, path, attempted, ErrorCode::ReadFailed);
    std::vector<char> piece(pieceBytes);
    while (file) {
        if (control.isCancelled())
            return cancelledError(attempted);
        file.read(piece.data(), std::streamsize(piece.size()));
        hash.add(std::as_bytes(std::span(piece.data(), std::size_t(file.gcount()))));
    }
    if (file.bad())
        return systemErrorFor(errno, path, attempted, ErrorCode::ReadFailed);
    return {};
}

} // namespace

Result<std::string> clipDigest(const fs::path &path, const JobControl &control)
{
    control.progress(0.0, attempted);
    Sha256 hash;
    std::error_code failure;
    if (!fs::is_directory(path, failure)) {
        if (Result<void> added = addFile(path, hash, control); !added)
            return added.error();
        return hash.hexDigest();
    }
    std::vector<fs::path> files;
    for (fs::directory_iterator file(path, failure), end; !failure && file != end; file.increment(failure))
        if (isPictureFile(file->path()))
            files.push_back(file->path());
    if (failure)
        return systemErrorFor(failure.value(), path, attempted, ErrorCode::ReadFailed);
    std::sort(files.begin(), files.end());
    for (const fs::path &file : files) {
        const std::string name = file.filename().string();
        hash.add(std::as_bytes(std::span(name.c_str(), name.size() + 1))); // with its end
        const std::uint64_t bytes = fs::file_size(file, failure);
        hash.add(std::as_bytes(std::span(&bytes, 1)));
        if (Result<void> added = addFile(file, hash, control); !added)
            return added.error();
    }
    return hash.hexDigest();
}

} // namespace ductus
