#include "base/background_work.h"

#include <algorithm>
#include <sys/resource.h>
#include <tbb/task_scheduler_observer.h>
#include <unistd.h>

namespace ductus {

namespace {

// A tenth of what a window's threads get where there are not enough cores for all.
constexpr int giveWay = 10, mostNice = 19;

// Nice values are a thread's own on Linux. A refusal only costs smoothness.
void lowerPriority()
{
    const id_t thread = id_t(gettid());
    const int program = getpriority(PRIO_PROCESS, id_t(getpid()));
    setpriority(PRIO_PROCESS, thread, std::min(mostNice, program + giveWay));
}

} // namespace

class BackgroundWork::Helpers : public tbb::task_scheduler_observer
{
public:
    Helpers() { observe(true); }
    ~Helpers() override { observe(false); }

    void on_scheduler_entry(bool isHelper) override
    {
        if (isHelper)
            lowerPriority();
    }
};

BackgroundWork::BackgroundWork()
{
    lowerPriority();
    mHelpers = std::make_unique<Helpers>();
}

BackgroundWork::~BackgroundWork() = default;

} // namespace ductus
