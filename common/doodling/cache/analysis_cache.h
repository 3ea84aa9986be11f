// Where what was found out about clips is kept between runs: a folder a clip and way of looking, safe to
// delete at any time. The folders used longest ago make room for new ones.
#pragma once

#include "base/result.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace ductus {

struct AnalysisCache
{
    std::filesystem::path root;            // empty: nothing is kept
    std::uint64_t mostBytes = 12ull << 30; // of all clips together; a minute of film has about two

    bool isOn() const { return !root.empty(); }

    /// The folder of \a key, made if it is not there and marked as used now; others are removed until all
    /// fits. PermissionDenied, WriteFailed.
    Result<std::filesystem::path> folder(const std::string &key) const;
    /// Removes what was used longest ago until all is within bounds; never \a keptKey.
    void makeRoom(const std::string &keptKey) const;
};

/// $XDG_CACHE_HOME/ductus/clips, or below ~/.cache; off where there is no home. DUCTUS_CACHE_MEGABYTES sets
/// the bound, 0 turns it off.
AnalysisCache userAnalysisCache();

} // namespace ductus
