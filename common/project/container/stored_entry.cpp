#include "project/container/stored_entry.h"

#include <zlib.h>

#include <new>

namespace ductus {

namespace {

// Level 6 takes five times as long as level 3 on coordinates and saves hardly a percent.
constexpr int packLevel = 3;
constexpr int rawDeflate = -15; // zip entries carry no zlib header
constexpr std::size_t worthPacking = 64;

std::uint32_t checksum(std::span<const std::byte> bytes)
{
    return std::uint32_t(::crc32_z(0, reinterpret_cast<const Bytef *>(bytes.data()), bytes.size()));
}

Error malformed(const std::string &place, std::string problem)
{
    return {ErrorCode::Malformed, "Unpacking an entry of the project", std::move(problem),
            "Open the previous version of the file, its name ends in ~", place};
}

// Empty if the bytes do not get smaller.
Bytes deflated(std::span<const std::byte> bytes)
{
    Bytes out;
    if (bytes.size() < worthPacking || bytes.size() > ContainerLimits().maxEntryBytes)
        return out;
    z_stream stream = {};
    if (deflateInit2(&stream, packLevel, Z_DEFLATED, rawDeflate, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        return out;
    out.resize(bytes.size());
    stream.next_in = const_cast<Bytef *>(reinterpret_cast<const Bytef *>(bytes.data()));
    stream.avail_in = uInt(bytes.size());
    stream.next_out = reinterpret_cast<Bytef *>(out.data());
    stream.avail_out = uInt(out.size());
    const bool finished = deflate(&stream, Z_FINISH) == Z_STREAM_END;
    out.resize(finished ? stream.total_out : 0);
    deflateEnd(&stream);
    out.shrink_to_fit();
    return out;
}

} // namespace

StoredEntry storedEntry(std::string name, std::span<const std::byte> bytes)
{
    return {std::move(name), PackMethod::Stored, checksum(bytes), bytes.size(),
            std::make_shared<const Bytes>(bytes.begin(), bytes.end())};
}

StoredEntry packedEntry(std::string name, std::span<const std::byte> bytes)
{
    Bytes packed = deflated(bytes);
    const ContainerLimits limits;
    const bool looksLikeBomb =
        bytes.size() > limits.ratioFreeBytes && bytes.size() / limits.maxRatio >= packed.size();
    if (packed.empty() || looksLikeBomb)
        return storedEntry(std::move(name), bytes);
    return {std::move(name), PackMethod::Deflated, checksum(bytes), bytes.size(),
            std::make_shared<const Bytes>(std::move(packed))};
}

Result<Bytes> unpacked(const StoredEntry &entry, const std::string &place)
try {
    if (entry.size > ContainerLimits().maxEntryBytes)
        return Error{ErrorCode::TooLarge, "Unpacking an entry of the project", "the entry is too large", "",
                     place};
    if (entry.method == PackMethod::Stored) {
        if (entry.packed->size() != entry.size || checksum(*entry.packed) != entry.crc32)
            return malformed(place, "the size or the checksum does not match, the file is damaged");
        return *entry.packed;
    }
    Bytes out(entry.size);
    std::byte none{}; // zlib wants a pointer even where there is nothing to write
    z_stream stream = {};
    if (inflateInit2(&stream, rawDeflate) != Z_OK)
        return Error{ErrorCode::ReadFailed, "Unpacking an entry of the project", "there is not enough memory",
                     "", place};
    stream.next_in = const_cast<Bytef *>(reinterpret_cast<const Bytef *>(entry.packed->data()));
    stream.avail_in = uInt(entry.packed->size());
    stream.next_out = reinterpret_cast<Bytef *>(out.empty() ? &none : out.data());
    stream.avail_out = uInt(out.size());
    const bool finished = inflate(&stream, Z_FINISH) == Z_STREAM_END;
    const bool complete = finished && stream.total_out == out.size() && stream.avail_in == 0;
    inflateEnd(&stream);
    if (!complete || checksum(out) != entry.crc32)
        return malformed(place, "the packed bytes are damaged or do not have the size they claim");
    return out;
} catch (const std::bad_alloc &) {
    return Error{ErrorCode::TooLarge, "Unpacking an entry of the project", "there is not enough memory", "",
                 place};
}

} // namespace ductus
