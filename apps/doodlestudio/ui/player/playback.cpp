#include "doodlestudio/ui/player/playback.h"

#include "doodlestudio/ui/player/sound_output.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr int tickMs = 8; // finer than any frame

} // namespace

Playback::Playback(QObject *parent) : QObject(parent), mSound(std::make_unique<SoundOutput>())
{
    mTimer.setTimerType(Qt::PreciseTimer);
    mTimer.setInterval(tickMs);
    connect(&mTimer, &QTimer::timeout, this, &Playback::tick);
}

Playback::~Playback() = default;

void Playback::setFrameTimes(std::vector<double> times)
{
    stop();
    mTimes = std::move(times);
    mFirst = mLast = -1;
    mFrameDuration = mTimes.size() > 1 ? (mTimes.back() - mTimes.front()) / double(mTimes.size() - 1) : 0.04;
    mFrame = 0;
    emit frameChanged(0);
}

void Playback::setSound(std::shared_ptr<const ClipSound> sound)
{
    mSound->setSound(std::move(sound));
    restartSound();
}

double Playback::timeOf(int frame) const
{
    return mTimes.empty() ? 0.0 : mTimes[std::size_t(std::clamp(frame, 0, frameCount() - 1))];
}

int Playback::frameAt(double seconds) const
{
    if (mTimes.empty())
        return 0;
    const auto after = std::upper_bound(mTimes.begin(), mTimes.end(), seconds + 1e-6);
    return std::clamp(int(after - mTimes.begin()) - 1, 0, frameCount() - 1);
}

double Playback::duration() const
{
    return mTimes.empty() ? 0.0 : mTimes.back() + mFrameDuration;
}

void Playback::setMuted(bool muted)
{
    mIsMuted = muted;
    restartSound();
}

void Playback::setRange(int first, int last)
{
    mFirst = first;
    mLast = last;
}

int Playback::firstFrame() const
{
    return mFirst < 0 ? 0 : std::min(mFirst, frameCount() - 1);
}

int Playback::lastFrame() const
{
    return mLast < 0 ? frameCount() - 1 : std::min(mLast, frameCount() - 1);
}

void Playback::setFrame(int frame)
{
    if (mTimes.empty())
        return;
    frame = std::clamp(frame, 0, frameCount() - 1);
    const bool isChanged = frame != mFrame;
    mFrame = frame;
    if (isPlaying()) {
        restartClock();
        restartSound();
    }
    if (isChanged)
        emit frameChanged(mFrame);
}

void Playback::step(int frames)
{
    stop();
    setFrame(mFrame + frames);
}

void Playback::play(double rate)
{
    if (mTimes.empty() || rate == 0.0) {
        stop();
        return;
    }
    const bool wasPlaying = isPlaying();
    mRate = rate;
    // At the end, play means once more.
    if (!wasPlaying && rate > 0.0 && mFrame >= lastFrame()) {
        mFrame = firstFrame();
        emit frameChanged(mFrame);
    }
    restartClock();
    restartSound();
    mTimer.start();
    if (!wasPlaying)
        emit playingChanged(true);
}

void Playback::stop()
{
    if (!isPlaying())
        return;
    mRate = 0.0;
    mTimer.stop();
    restartSound();
    emit playingChanged(false);
}

void Playback::toggle()
{
    isPlaying() ? stop() : play();
}

void Playback::restartClock()
{
    mClockStart = time();
    mClock.start();
}

void Playback::restartSound()
{
    // Faster or backwards nothing can be understood.
    if (mRate == 1.0 && !mIsMuted)
        mSound->play(time());
    else
        mSound->stop();
}

void Playback::tick()
{
    const double begin = timeOf(firstFrame());
    const double end = lastFrame() + 1 < frameCount() ? timeOf(lastFrame() + 1) : duration();
    double now = mClockStart + mRate * double(mClock.nsecsElapsed()) * 1e-9;
    bool isRestarted = false;
    if (now >= end || now < begin) {
        now = mRate > 0.0 ? begin : std::max(begin, end - 1e-6);
        isRestarted = true;
    }
    const int frame = frameAt(now);
    const bool isChanged = frame != mFrame;
    mFrame = frame;
    if (isRestarted) {
        mClockStart = now;
        mClock.start();
        restartSound();
    }
    if (isChanged)
        emit frameChanged(mFrame);
}

} // namespace ductus
