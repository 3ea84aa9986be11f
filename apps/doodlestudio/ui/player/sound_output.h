// SoundOutput: plays a clip's sound from any moment, if the computer has something to hear it with. Without
// that it does nothing: the pictures go by a clock of their own.
#pragma once

#include "doodling/clip/clip_sound.h"

#include <QBuffer>
#include <memory>

class QAudioSink;

namespace ductus {

class SoundOutput
{
public:
    SoundOutput();
    ~SoundOutput();

    void setSound(std::shared_ptr<const ClipSound> sound);
    /// From \a seconds of the clip to the end.
    void play(double seconds);
    void stop();

private:
    bool makeSink();

    std::shared_ptr<const ClipSound> mSound;
    std::unique_ptr<QAudioSink> mSink;
    QByteArray mBytes; // a view of mSound's samples, with silence before if the sound begins later
    QBuffer mBuffer;
    bool mIsSilent = false; // no device takes this sound
};

} // namespace ductus
