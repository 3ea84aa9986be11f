// Assertions that stay on in release builds: a broken invariant is a bug and must not reach the user's file.
#pragma once

namespace ductus {

/// Prints file, line and condition to stderr and aborts.
[[noreturn]] void assertionFailed(const char *condition, const char *file, int line);

} // namespace ductus

#define DUCTUS_ASSERT(condition)                                                                             \
    ((condition) ? static_cast<void>(0) : ::ductus::assertionFailed(#condition, __FILE__, __LINE__))
