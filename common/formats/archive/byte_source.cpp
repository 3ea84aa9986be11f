#include "formats/archive/byte_source.h"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace ductus {

namespace {

constexpr char attempted[] = "Reading the painting";
constexpr std::size_t bufferSize = 1 << 16;

class FileSource : public ByteSource
{
public:
    FileSource(std::ifstream stream, std::string name, std::uint64_t size)
        : ByteSource(std::move(name), size), mStream(std::move(stream))
    {
    }

protected:
    Result<void> readInside(std::uint64_t offset, std::span<std::byte> destination) override
    {
        mStream.clear();
        mStream.seekg(std::streamoff(offset));
        mStream.read(reinterpret_cast<char *>(destination.data()), std::streamsize(destination.size()));
        if (!mStream)
            return Error{ErrorCode::ReadFailed, attempted, "the disk did not give the data",
                         "Copy the file to another disk and try again", place(offset)};
        return {};
    }

private:
    std::ifstream mStream;
};

class MemorySource : public ByteSource
{
public:
    MemorySource(std::string_view bytes, std::string name)
        : ByteSource(std::move(name), bytes.size()), mBytes(bytes)
    {
    }

protected:
    Result<void> readInside(std::uint64_t offset, std::span<std::byte> destination) override
    {
        std::memcpy(destination.data(), mBytes.data() + offset, destination.size());
        return {};
    }

private:
    std::string_view mBytes;
};

} // namespace

std::string ByteSource::place(std::uint64_t offset) const
{
    return mName + ": byte " + std::to_string(offset);
}

Result<void> ByteSource::read(std::uint64_t offset, std::span<std::byte> destination)
{
    if (offset > mSize || destination.size() > mSize - offset)
        return Error{ErrorCode::Malformed, attempted,
                     std::to_string(destination.size()) +
                         " bytes are wanted there, but the file ends at byte " + std::to_string(mSize),
                     "The file is cut off: copy or export it again", place(offset)};
    if (destination.empty())
        return {};
    return readInside(offset, destination);
}

Result<std::unique_ptr<ByteSource>> openFileSource(const std::filesystem::path &path, std::string name)
{
    std::error_code code;
    const auto status = std::filesystem::status(path, code);
    if (status.type() == std::filesystem::file_type::not_found)
        return Error{ErrorCode::FileNotFound, attempted, "there is no such file", "Check the name", name};
    if (std::filesystem::is_directory(status))
        return Error{ErrorCode::NotAFile, attempted, "this is a folder", "Name the file inside", name};
    if (!std::filesystem::is_regular_file(status))
        return Error{ErrorCode::NotAFile, attempted, "this is no regular file", "Name a file on a disk",
                     name};
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        return Error{ErrorCode::PermissionDenied, attempted, "the file cannot be opened",
                     "Check its permissions", name};
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    if (code)
        return Error{ErrorCode::ReadFailed, attempted, code.message(), "", name};
    return std::unique_ptr<ByteSource>(new FileSource(std::move(stream), std::move(name), size));
}

std::unique_ptr<ByteSource> memorySource(std::string_view bytes, std::string name)
{
    return std::make_unique<MemorySource>(bytes, std::move(name));
}

Result<void> BufferedBytes::read(std::span<std::byte> destination)
{
    while (!destination.empty()) {
        if (mOffset >= mBufferOffset && mOffset - mBufferOffset < mBuffer.size()) {
            const std::size_t begin = std::size_t(mOffset - mBufferOffset);
            const std::size_t count = std::min(destination.size(), mBuffer.size() - begin);
            std::memcpy(destination.data(), mBuffer.data() + begin, count);
            destination = destination.subspan(count);
            mOffset += count;
            continue;
        }
        // What is large goes straight to its place; so does what reaches beyond the end, for the error.
        if (destination.size() >= bufferSize || destination.size() > remaining()) {
            const Result<void> done = mSource.read(mOffset, destination);
            if (done)
                mOffset += destination.size();
            return done;
        }
        mBuffer.resize(std::size_t(std::min<std::uint64_t>(bufferSize, remaining())));
        mBufferOffset = mOffset;
        const Result<void> done = mSource.read(mOffset, mBuffer);
        if (!done) {
            mBuffer.clear();
            return done;
        }
    }
    return {};
}

Result<void> BufferedBytes::skip(std::uint64_t count)
{
    if (count > remaining())
        return Error{ErrorCode::Malformed, attempted,
                     std::to_string(count) + " bytes are announced there, but only " +
                         std::to_string(remaining()) + " are left",
                     "The file is cut off: copy or export it again", mSource.place(mOffset)};
    mOffset += count;
    return {};
}

} // namespace ductus
