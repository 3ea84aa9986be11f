// Reading a .ductus container (a zip) without trusting it: bytes in, checked entries in packed form out.
#pragma once

#include "base/result.h"
#include "project/container/stored_entry.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace ductus {

inline constexpr std::string_view ductusMimeType = "application/vnd.ductus.project+zip";

struct Container
{
    std::map<std::string, StoredEntry, std::less<>> entries; // without the mimetype
    std::vector<std::string> warnings;                       // what a save will mend

    const StoredEntry *find(std::string_view name) const;
};

/// Opens a container held in memory; \a name (the file's) starts every place in errors. Refused before
/// anything is allocated: too many or too large entries, zip bombs (packing ratio, overlapping entries),
/// encryption, other methods than Store and Deflate, names that repeat or lead out of the container, a
/// missing or wrong mimetype, local headers that contradict the central directory. Contents are checked when
/// they are unpacked.
Result<Container> readContainer(std::span<const std::byte> bytes, const std::string &name,
                                const ContainerLimits &limits = {});

} // namespace ductus
