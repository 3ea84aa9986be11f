// Writing a .ductus container: entries in packed form in, the bytes of a zip out. The same entries give the
// same bytes (fixed dates, fixed order), packed bytes are copied as they are.
#pragma once

#include "base/result.h"
#include "project/container/stored_entry.h"

#include <span>

namespace ductus {

/// A zip whose first entry is the mimetype, stored, without extra field; then \a entries in their order (the
/// caller puts thumbnail.png first). Fails with TooLarge where readContainer() would refuse the result, with
/// InvalidArgument for a bad or repeated name.
Result<Bytes> writtenContainer(std::span<const StoredEntry> entries, const ContainerLimits &limits = {});

} // namespace ductus
