#include "base/background_work.h"

#include "base/parallel.h"

#include <QtTest>
#include <algorithm>
#include <mutex>
#include <set>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

using namespace ductus;

namespace {

int niceOfThread()
{
    return getpriority(PRIO_PROCESS, id_t(gettid()));
}

// Nice values of all threads that took part in a long enough loop.
std::set<int> nicesInParallel()
{
    std::mutex mutex;
    std::set<int> nices;
    parallelFor(0, 64, [&](std::size_t) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        const std::lock_guard lock(mutex);
        nices.insert(niceOfThread());
    });
    return nices;
}

} // namespace

class BackgroundWorkTest : public QObject
{
    Q_OBJECT
private slots:
    void jobAndHelpersGiveWay()
    {
        const int before = niceOfThread();
        if (before >= 19)
            QSKIP("this program already runs at the lowest priority");
        std::set<int> nices;
        std::thread job([&] {
            const BackgroundWork background;
            nices = nicesInParallel();
        });
        job.join();
        QVERIFY(!nices.empty());
        QVERIFY(*nices.begin() > before);
        QCOMPARE(*nices.begin(), std::min(19, before + 10));
    }

    void theWindowsThreadKeepsItsPriority()
    {
        const int before = niceOfThread();
        std::thread([] { const BackgroundWork background; }).join();
        QCOMPARE(niceOfThread(), before);
    }
};

QTEST_GUILESS_MAIN(BackgroundWorkTest)
#include "background_work_test.moc"
