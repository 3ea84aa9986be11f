#include "project/arrays/buffer_store.h"

#include "base/sha256.h"
#include "project/container/entry_name.h"

namespace ductus {

bool BufferStore::addEntry(StoredEntry entry)
{
    const std::string hash(sha256OfBufferEntry(entry.name));
    if (hash.empty())
        return false;
    mEntries.emplace(hash, std::move(entry));
    return true;
}

std::string BufferStore::add(std::span<const std::byte> bytes)
{
    std::string hash = sha256Hex(bytes);
    if (!mEntries.contains(hash))
        mEntries.emplace(hash, packedEntry(bufferEntryName(hash), bytes));
    return hash;
}

const StoredEntry *BufferStore::find(std::string_view sha256) const
{
    const auto found = mEntries.find(sha256);
    return found == mEntries.end() ? nullptr : &found->second;
}

} // namespace ductus
