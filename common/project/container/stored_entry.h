// StoredEntry: one entry of a container in its packed form. Entries that are kept or copied are never
// unpacked; copies of the value share the packed bytes, so a snapshot of a project costs nothing.
#pragma once

#include "base/result.h"
#include "project/container/limits.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ductus {

using Bytes = std::vector<std::byte>;

inline std::span<const std::byte> asBytes(std::string_view text)
{
    return std::as_bytes(std::span(text.data(), text.size()));
}

enum class PackMethod : std::uint16_t { Stored = 0, Deflated = 8 }; // numbers of the zip format

struct StoredEntry
{
    std::string name;
    PackMethod method = PackMethod::Stored;
    std::uint32_t crc32 = 0;             // of the unpacked bytes
    std::uint64_t size = 0;              // unpacked
    std::shared_ptr<const Bytes> packed; // never null
};

/// Packs \a bytes with Deflate where that helps; stores them otherwise, also where they would pack so well
/// that a reader had to take the entry for a zip bomb. The same bytes give the same entry (with the same
/// zlib).
StoredEntry packedEntry(std::string name, std::span<const std::byte> bytes);

/// The same without packing.
StoredEntry storedEntry(std::string name, std::span<const std::byte> bytes);

/// The unpacked bytes; Malformed (at \a place) unless they have exactly the size and checksum the entry
/// claims. The size was bounded when the container was read.
Result<Bytes> unpacked(const StoredEntry &entry, const std::string &place);

} // namespace ductus
