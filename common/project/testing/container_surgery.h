// Containers taken apart and put together wrong, for tests of the readers.
#pragma once

#include "project/container/container_reader.h"
#include "project/container/container_writer.h"

#include <functional>
#include <string>

namespace ductus {

inline std::string textOf(const StoredEntry &entry)
{
    const Result<Bytes> bytes = unpacked(entry, entry.name);
    return bytes ? std::string(reinterpret_cast<const char *>(bytes->data()), bytes->size()) : "not readable";
}

/// The container with its entries changed by \a change; the mimetype is written anew.
inline Bytes operatedOn(const Bytes &container, const std::function<void(Container &)> &change)
{
    Container parts = *readContainer(container, "operated");
    change(parts);
    std::vector<StoredEntry> entries;
    for (const auto &[name, entry] : parts.entries)
        entries.push_back(entry);
    return *writtenContainer(entries);
}

/// One text entry with every \a from replaced by \a to.
inline Bytes withReplaced(const Bytes &container, const std::string &entryName, const std::string &from,
                          const std::string &to)
{
    return operatedOn(container, [&](Container &parts) {
        std::string text = textOf(parts.entries.at(entryName));
        DUCTUS_ASSERT(text.find(from) != std::string::npos);
        for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
            text.replace(at, from.size(), to);
        parts.entries[entryName] = packedEntry(entryName, asBytes(text));
    });
}

/// All occurrences of \a from in the raw bytes replaced by \a to of the same length (names in a zip stand
/// there twice).
inline Bytes withBytesReplaced(Bytes bytes, std::string_view from, std::string_view to)
{
    DUCTUS_ASSERT(from.size() == to.size());
    std::string text(reinterpret_cast<const char *>(bytes.data()), bytes.size());
    DUCTUS_ASSERT(text.find(from) != std::string::npos);
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    const std::span<const std::byte> changed = asBytes(text);
    return Bytes(changed.begin(), changed.end());
}

} // namespace ductus
