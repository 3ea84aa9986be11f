// save_loop PATH: saves two projects in turn over the same path until it is killed. Tells a line before the
// first save.
#include "kill_states.h"
#include "project/saving/project_lock.h"
#include "project/saving/project_save.h"

#include <cstdio>

int main(int argc, char *argv[])
{
    using namespace ductus;
    if (argc != 2)
        return 2;
    const Result<ProjectLock> lock = ProjectLock::acquire(argv[1], "save_loop");
    if (!lock) {
        std::fprintf(stderr, "%s\n", lock.error().message().c_str());
        return 1;
    }
    const Project states[] = {killState(0), killState(1)};
    std::puts("saving");
    std::fflush(stdout);
    for (int i = 0;; ++i) {
        const Result<SaveReport> report = saveProject(states[i % 2], argv[1]);
        if (!report || !report->warnings.empty()) {
            std::fprintf(stderr, "%s\n",
                         report ? report->warnings[0].c_str() : report.error().message().c_str());
            return 1;
        }
    }
}
