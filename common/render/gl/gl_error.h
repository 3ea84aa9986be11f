// What OpenGL complained about, as an Error.
#pragma once

#include "base/result.h"

namespace ductus {

/// Takes all pending errors of the current context; Unsupported (TooLarge when memory ran out) naming them.
Result<void> checkGl(const char *attempted);

/// What the current context lacks for common/render: Unsupported naming the version or extension, and what to
/// do. \a attempted as in Error.
Result<void> checkGlVersion(const char *attempted);

} // namespace ductus
