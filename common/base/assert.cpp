#include "base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace ductus {

void assertionFailed(const char *condition, const char *file, int line)
{
    std::fprintf(stderr, "%s:%d: internal error, this must hold: %s\n", file, line, condition);
    std::abort();
}

} // namespace ductus
