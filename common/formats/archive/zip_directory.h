// A look at the end of a zip file before libzip sees it: libzip allocates for as many entries as the
// directory claims.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace ductus {

/// The largest number of entries any end-of-directory record in the last 64 kB claims, zip64 records
/// included.
std::uint64_t largestEntryCount(std::span<const std::byte> bytes);

} // namespace ductus
