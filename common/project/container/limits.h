// Bounds every .ductus container must keep. The reader checks them before it allocates, the writer before it
// writes, so that Ductus never makes a file it would refuse to open.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ductus {

struct ContainerLimits
{
    std::uint64_t maxFileBytes = 2ull << 30; // the zip itself
    std::uint64_t maxEntries = 100'000;
    std::uint64_t maxEntryBytes = 1ull << 30;  // one entry, unpacked
    std::uint64_t maxTotalBytes = 2ull << 30;  // all entries, unpacked
    std::uint64_t maxRatio = 200;              // unpacked : packed, of entries larger than ratioFreeBytes
    std::uint64_t ratioFreeBytes = 1ull << 20; // small entries may pack better: they cannot hurt
    std::uint64_t maxJsonBytes = 64ull << 20;  // project.json, one document
    std::size_t maxJsonDepth = 64;             // nesting of arrays and objects
    std::uint64_t maxArrayBytes = 2ull << 30;  // all arrays of all documents together
    std::size_t maxDocuments = 10'000;
    std::size_t maxNameLength = 512; // bytes of an entry name or a document name
};

} // namespace ductus
