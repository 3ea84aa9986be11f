// Playback: which frame of the clip is shown now. A clock that goes by the frames' own times, forwards or
// backwards, in a loop; the sound follows it when it can be heard.
#pragma once

#include "doodling/clip/clip_sound.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

namespace ductus {

class SoundOutput;

class Playback : public QObject
{
    Q_OBJECT
public:
    explicit Playback(QObject *parent = nullptr);
    ~Playback() override;

    /// One time a frame, seconds from the first one. Stops and goes to the first frame.
    void setFrameTimes(std::vector<double> times);
    void setSound(std::shared_ptr<const ClipSound> sound);

    int frameCount() const { return int(mTimes.size()); }
    int frame() const { return mFrame; }
    double time() const { return mTimes.empty() ? 0.0 : mTimes[std::size_t(mFrame)]; }
    double timeOf(int frame) const;
    int frameAt(double seconds) const;
    double duration() const;
    bool isPlaying() const { return mRate != 0.0; }
    /// 1 as filmed, -1 backwards, 2 twice as fast, 0 standing.
    double rate() const { return mRate; }
    bool isMuted() const { return mIsMuted; }
    void setMuted(bool muted);
    /// Only these frames are played, in a loop; -1: all.
    void setRange(int first, int last);

    void setFrame(int frame);
    void step(int frames);
    void play(double rate = 1.0);
    void stop();
    void toggle();

signals:
    void frameChanged(int frame);
    void playingChanged(bool playing);

private:
    void tick();
    void restartClock();
    void restartSound();
    int firstFrame() const;
    int lastFrame() const;

    std::vector<double> mTimes;
    double mFrameDuration = 0.04; // of the last frame, seconds
    std::unique_ptr<SoundOutput> mSound;
    QTimer mTimer;
    QElapsedTimer mClock;
    double mClockStart = 0.0; // seconds of the clip when mClock was started
    double mRate = 0.0;
    int mFrame = 0;
    int mFirst = -1, mLast = -1;
    bool mIsMuted = false;
};

} // namespace ductus
