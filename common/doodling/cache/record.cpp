#include "doodling/cache/record.h"

#include "formats/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <unistd.h>

namespace ductus {

namespace {

constexpr char magic[8] = {'D', 'U', 'C', 'T', 'R', 'E', 'C', '1'};
constexpr std::size_t headBytes = 24; // magic, sum, bytes that follow
constexpr char attempted[] = "Keeping what was found out about the clip";

std::size_t padded(std::size_t bytes)
{
    return (bytes + 7) / 8 * 8;
}

std::uint64_t wordAt(const std::byte *bytes)
{
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, sizeof word);
    return word;
}

// Four lanes of multiply and rotate: as fast as memory, and no word or its place can change unnoticed.
std::uint64_t sumOf(std::span<const std::byte> bytes)
{
    constexpr std::uint64_t factor = 0x9E3779B97F4A7C15ull;
    std::uint64_t lanes[4] = {1, 2, 3, 4};
    for (std::size_t word = 0; word < bytes.size() / 8; ++word) {
        std::uint64_t &lane = lanes[word % 4];
        lane = (lane ^ wordAt(bytes.data() + 8 * word)) * factor;
        lane ^= lane >> 29;
    }
    std::uint64_t sum = bytes.size();
    for (std::uint64_t lane : lanes)
        sum = (sum ^ lane) * factor ^ (sum >> 31);
    return sum;
}

} // namespace

RecordWriter::RecordWriter() : mBytes(headBytes) {}

void RecordWriter::addBytes(std::span<const std::byte> bytes)
{
    const std::uint64_t count = bytes.size();
    const std::size_t at = mBytes.size();
    mBytes.resize(at + 8 + padded(bytes.size()));
    std::memcpy(mBytes.data() + at, &count, 8);
    if (!bytes.empty())
        std::memcpy(mBytes.data() + at + 8, bytes.data(), bytes.size());
}

Result<void> RecordWriter::write(const std::filesystem::path &path) const
{
    const std::span<const std::byte> content = std::span(mBytes).subspan(headBytes);
    const std::uint64_t head[2] = {sumOf(content), content.size()};
    // A name of its own: two programs may look at the same clip.
    static std::atomic<unsigned> counter = 0;
    std::filesystem::path beside = path;
    beside += "." + std::to_string(::getpid()) + "." + std::to_string(counter++) + ".part";
    const auto failure = [&](int problem) {
        ::unlink(beside.c_str());
        Error error = systemErrorFor(problem, path, attempted, ErrorCode::WriteFailed);
        error.code = ErrorCode::WriteFailed; // whatever the reason: the caller goes on without a cache
        if (problem == ENOSPC)
            error.remedy = "Make room on the disk, or name another folder in XDG_CACHE_HOME";
        return error;
    };
    std::FILE *file = std::fopen(beside.c_str(), "wbx");
    if (!file)
        return failure(errno);
    bool isWritten = std::fwrite(magic, sizeof magic, 1, file) == 1 &&
                     std::fwrite(head, sizeof head, 1, file) == 1 &&
                     (content.empty() || std::fwrite(content.data(), content.size(), 1, file) == 1);
    int problem = errno;
    if (std::fclose(file) != 0) {
        isWritten = false;
        problem = errno;
    }
    if (!isWritten)
        return failure(problem);
    if (std::rename(beside.c_str(), path.c_str()) != 0)
        return failure(errno);
    return {};
}

RecordReader::RecordReader(std::shared_ptr<const MappedFile> file) : mFile(std::move(file)), mAt(headBytes)
{
    const std::span<const std::byte> bytes = mFile ? mFile->bytes() : std::span<const std::byte>();
    mIsFailed = bytes.size() < headBytes || std::memcmp(bytes.data(), magic, sizeof magic) != 0 ||
                wordAt(bytes.data() + 16) != bytes.size() - headBytes || bytes.size() % 8 != 0;
}

bool RecordReader::isSound() const
{
    return !mIsFailed && sumOf(mFile->bytes().subspan(headBytes)) == wordAt(mFile->bytes().data() + 8);
}

std::vector<double> RecordReader::numbers()
{
    const std::optional<std::span<const std::byte>> bytes = next();
    if (!bytes || bytes->size() % sizeof(double) != 0) {
        mIsFailed = true;
        return {};
    }
    std::vector<double> values(bytes->size() / sizeof(double));
    if (!values.empty())
        std::memcpy(values.data(), bytes->data(), bytes->size());
    return values;
}

bool RecordReader::isAtEnd() const
{
    return !mIsFailed && mAt == mFile->bytes().size();
}

std::optional<std::span<const std::byte>> RecordReader::next()
{
    if (mIsFailed || mFile->bytes().size() - mAt < 8)
        return std::nullopt;
    const std::span<const std::byte> rest = mFile->bytes().subspan(mAt + 8);
    const std::uint64_t count = wordAt(mFile->bytes().data() + mAt);
    if (count > rest.size() || padded(count) > rest.size())
        return std::nullopt;
    mAt += 8 + padded(count);
    return rest.first(count);
}

} // namespace ductus
