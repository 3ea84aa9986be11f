#include "formats/archive/zip_directory.h"

#include <algorithm>

namespace ductus {

namespace {

// Sizes and offsets from APPNOTE.TXT 6.3.9, sections 4.3.14 to 4.3.16.
constexpr std::size_t endRecordSize = 22;
constexpr std::size_t locatorSize = 20;
constexpr std::size_t end64RecordSize = 56;
constexpr std::size_t maxCommentSize = 65535;
constexpr std::uint64_t endSignature = 0x06054b50;
constexpr std::uint64_t locatorSignature = 0x07064b50;

std::uint64_t littleEndian(std::span<const std::byte> bytes, std::size_t offset, int byteCount)
{
    std::uint64_t value = 0;
    for (int k = byteCount - 1; k >= 0; --k)
        value = value << 8 | std::uint64_t(bytes[offset + std::size_t(k)]);
    return value;
}

std::uint64_t zip64EntryCount(std::span<const std::byte> bytes, std::size_t endRecord)
{
    if (endRecord < locatorSize || littleEndian(bytes, endRecord - locatorSize, 4) != locatorSignature)
        return 0;
    const std::uint64_t record = littleEndian(bytes, endRecord - locatorSize + 8, 8);
    if (record > bytes.size() || bytes.size() - record < end64RecordSize)
        return 0;
    return std::max(littleEndian(bytes, record + 24, 8), littleEndian(bytes, record + 32, 8));
}

} // namespace

std::uint64_t largestEntryCount(std::span<const std::byte> bytes)
{
    if (bytes.size() < endRecordSize)
        return 0;
    std::uint64_t largest = 0;
    const std::size_t last = bytes.size() - endRecordSize;
    const std::size_t first = last > maxCommentSize + 4096 ? last - maxCommentSize - 4096 : 0;
    for (std::size_t i = first; i <= last; ++i) {
        if (bytes[i] != std::byte('P') || littleEndian(bytes, i, 4) != endSignature)
            continue;
        largest = std::max({largest, littleEndian(bytes, i + 8, 2), littleEndian(bytes, i + 10, 2),
                            zip64EntryCount(bytes, i)});
    }
    return largest;
}

} // namespace ductus
