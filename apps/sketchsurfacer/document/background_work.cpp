#include "sketchsurfacer/document/background_work.h"

#ifdef __linux__
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace ductus {

void workInBackground()
{
#ifdef __linux__
    constexpr int niceness = 10;
    // Linux has a niceness for each thread; that it cannot be lowered is nothing to stop for.
    const auto thread = id_t(syscall(SYS_gettid));
    if (getpriority(PRIO_PROCESS, thread) < niceness)
        setpriority(PRIO_PROCESS, thread, niceness);
#endif
}

} // namespace ductus
