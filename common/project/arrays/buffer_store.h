// BufferStore: the buffers of a project by content hash, packed. Reading arrays goes through ArrayLoader,
// writing through BufferPacker (buffer_packer.h).
#pragma once

#include "project/container/stored_entry.h"

#include <map>
#include <string>

namespace ductus {

class BufferStore
{
public:
    /// Adds an entry named buffers/<sha256>.bin, unless it is there already; other names are refused (false).
    bool addEntry(StoredEntry entry);

    /// Packs and adds \a bytes unless a buffer with this content is there. Returns its hash.
    std::string add(std::span<const std::byte> bytes);

    const StoredEntry *find(std::string_view sha256) const;
    const std::map<std::string, StoredEntry, std::less<>> &entries() const { return mEntries; }

private:
    std::map<std::string, StoredEntry, std::less<>> mEntries; // by hash
};

} // namespace ductus
