#include "sketchsurfacer/ui/viewport/turntable.h"

#include "sketchsurfacer/ui/viewport/sketch_view.h"

namespace ductus {

namespace {

constexpr double secondsARound = 12.0;
constexpr int frameMilliseconds = 33;

} // namespace

Turntable::Turntable(SketchView &view, QObject *parent) : QObject(parent), mView(view)
{
    mTimer.setInterval(frameMilliseconds);
    connect(&mTimer, &QTimer::timeout, this, [this] {
        // By the clock: a slow picture makes larger steps, not a slower round.
        mView.turnBy(double(mClock.restart()) / 1000.0 / secondsARound);
    });
}

void Turntable::setTurning(bool on)
{
    if (on == isTurning())
        return;
    if (on) {
        mClock.start();
        mTimer.start();
    } else {
        mTimer.stop();
    }
}

void Turntable::takePictures(int count, std::function<bool(int number, const QImage &picture)> taken)
{
    auto *step = new QTimer(this);
    step->setInterval(0);
    connect(step, &QTimer::timeout, this,
            [this, step, count, taken = std::move(taken), number = 0]() mutable {
                const bool goesOn = taken(number, mView.smoothPicture());
                mView.turnBy(1.0 / count);
                if (goesOn && ++number < count)
                    return;
                for (; number + 1 < count && !goesOn; ++number)
                    mView.turnBy(1.0 / count); // round to where it began
                step->stop();
                step->deleteLater();
                emit picturesTaken();
            });
    step->start();
}

} // namespace ductus
