// WatchedApplication: an application that times every event it delivers: by the clock, and what the UI thread
// itself worked. What an event costs beyond a tenth of a second is a window that does not answer. On a
// machine that others use, too, the clock also counts what they take, so the work is what is judged.
#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QMetaEnum>
#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

namespace ductus::testing {

struct HeldUp
{
    QString by; // "MetaCall for SketchPresenter"
    double workMilliseconds = 0.0;
    double wallMilliseconds = 0.0;
};

class WatchedApplication : public QApplication
{
public:
    using QApplication::QApplication;

    bool notify(QObject *receiver, QEvent *event) override
    {
        if (mDepth++ > 0) { // part of the one around it
            const bool done = QApplication::notify(receiver, event);
            --mDepth;
            return done;
        }
        HeldUp held{nameOf(receiver, event), 0.0, 0.0};
        const double worked = work();
        QElapsedTimer clock;
        clock.start();
        const bool done = QApplication::notify(receiver, event);
        held.wallMilliseconds = double(clock.nsecsElapsed()) * 1e-6;
        held.workMilliseconds = work() - worked;
        --mDepth;
        if (held.workMilliseconds > mWorst.workMilliseconds)
            mWorst = held;
        mLongestWall = std::max(mLongestWall, held.wallMilliseconds);
        return done;
    }

    /// The event that took most work since the last time this was asked, and the longest by the clock.
    std::pair<HeldUp, double> takeWorst()
    {
        return {std::exchange(mWorst, {}), std::exchange(mLongestWall, 0.0)};
    }

private:
    static double work()
    {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
    }

    static QString nameOf(const QObject *receiver, const QEvent *event)
    {
        const char *type = QMetaEnum::fromType<QEvent::Type>().valueToKey(event->type());
        return QStringLiteral("%1 for %2 %3")
            .arg(QLatin1String(type ? type : "event"), QLatin1String(receiver->metaObject()->className()),
                 receiver->objectName());
    }

    int mDepth = 0;
    HeldUp mWorst;
    double mLongestWall = 0.0;
};

} // namespace ductus::testing
