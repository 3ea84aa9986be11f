#include "doodlestudio/ui/player/sound_output.h"

#include <QAudioSink>
#include <QMediaDevices>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

QAudioFormat formatOf(const ClipSound &sound)
{
    QAudioFormat format;
    format.setSampleRate(sound.sampleRate);
    format.setChannelCount(sound.channels);
    format.setSampleFormat(QAudioFormat::Int16);
    return format;
}

} // namespace

SoundOutput::SoundOutput() = default;

SoundOutput::~SoundOutput()
{
    stop();
}

void SoundOutput::setSound(std::shared_ptr<const ClipSound> sound)
{
    stop();
    mSink = nullptr;
    mIsSilent = false;
    mSound = std::move(sound);
    mBytes = {};
}

bool SoundOutput::makeSink()
{
    if (mSink)
        return true;
    if (mIsSilent || !mSound || mSound->isEmpty())
        return false;
    // Asked for at the first sound only: looking for devices takes a moment.
    const QAudioDevice device = QMediaDevices::defaultAudioOutput();
    if (device.isNull() || !device.isFormatSupported(formatOf(*mSound))) {
        mIsSilent = true;
        return false;
    }
    mSink = std::make_unique<QAudioSink>(device, formatOf(*mSound));
    mBytes = QByteArray::fromRawData(reinterpret_cast<const char *>(mSound->samples.data()),
                                     qsizetype(mSound->samples.size() * sizeof(std::int16_t)));
    if (mSound->startSeconds > 0.001) {
        const auto silence = qsizetype(std::lround(mSound->startSeconds * mSound->sampleRate));
        mBytes.prepend(silence * mSound->channels * 2, '\0');
    }
    return true;
}

void SoundOutput::play(double seconds)
{
    stop();
    if (!makeSink())
        return;
    const double skipped = seconds - std::min(0.0, mSound->startSeconds);
    const qint64 at = qint64(std::lround(skipped * mSound->sampleRate)) * mSound->channels * 2;
    if (at < 0 || at >= mBytes.size())
        return;
    mBuffer.close();
    mBuffer.setData(mBytes);
    mBuffer.open(QIODevice::ReadOnly);
    mBuffer.seek(at);
    mSink->start(&mBuffer);
}

void SoundOutput::stop()
{
    if (mSink)
        mSink->stop();
    mBuffer.close();
}

} // namespace ductus
