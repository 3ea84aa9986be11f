// ByteSource: bytes of known number that may lie in a file, in memory or packed in a zip; read piece by
// piece, so that files larger than the memory can be read. BufferedBytes reads small things from one, in
// order.
#pragma once

#include "base/result.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ductus {

class ByteSource
{
public:
    virtual ~ByteSource() = default;

    /// For messages: "flower/Quill.qbin".
    const std::string &name() const { return mName; }
    std::uint64_t size() const { return mSize; }

    /// Fills \a destination from byte \a offset on. Malformed with the offset if that reaches beyond the end.
    Result<void> read(std::uint64_t offset, std::span<std::byte> destination);

    /// "flower/Quill.qbin: byte 1234".
    std::string place(std::uint64_t offset) const;

protected:
    ByteSource(std::string name, std::uint64_t size) : mName(std::move(name)), mSize(size) {}

    /// The bytes are known to be inside.
    virtual Result<void> readInside(std::uint64_t offset, std::span<std::byte> destination) = 0;

private:
    std::string mName;
    std::uint64_t mSize;
};

/// Says apart: missing, a folder, no permission. \a name stands in messages.
Result<std::unique_ptr<ByteSource>> openFileSource(const std::filesystem::path &path, std::string name);

/// \a bytes must outlive the source.
std::unique_ptr<ByteSource> memorySource(std::string_view bytes, std::string name);

/// Little-endian values one after the other, through a buffer.
class BufferedBytes
{
public:
    BufferedBytes(ByteSource &source, std::uint64_t offset) : mSource(source), mOffset(offset) {}

    std::uint64_t offset() const { return mOffset; }
    std::uint64_t remaining() const { return mOffset < mSource.size() ? mSource.size() - mOffset : 0; }
    const ByteSource &source() const { return mSource; }

    Result<void> read(std::span<std::byte> destination);

    template <typename T>
    Result<T> read()
    {
        static_assert(std::is_arithmetic_v<T> && std::endian::native == std::endian::little);
        T value{};
        const Result<void> done = read(std::as_writable_bytes(std::span(&value, 1)));
        if (!done)
            return done.error();
        return value;
    }

    /// Malformed if fewer than \a count bytes are left.
    Result<void> skip(std::uint64_t count);

private:
    ByteSource &mSource;
    std::uint64_t mOffset;
    std::vector<std::byte> mBuffer;
    std::uint64_t mBufferOffset = 0;
};

} // namespace ductus
