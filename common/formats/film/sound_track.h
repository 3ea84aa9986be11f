// The sound of a film, as packets for another one: copied, or decoded and encoded anew.
#pragma once

#include "formats/film/av_handles.h"
#include "formats/film/film_writer.h"

#include <functional>

namespace ductus {

class SoundTrack
{
public:
    using Take = std::function<Result<void>(AVPacket &)>;

    virtual ~SoundTrack() = default;

    /// Of the track in the new file. The time base is what the packets' times count in.
    virtual const AVCodecParameters &parameters() const = 0;
    virtual AVRational timeBase() const = 0;

    /// Gives all packets that begin before \a seconds of the new film and were not given yet.
    virtual Result<void> advance(double seconds, const Take &take) = 0;
    /// Gives what encoders still hold.
    virtual Result<void> finish(const Take &take) = 0;
};

/// Null if \a options name no source or it has no sound. FileNotFound, Unsupported and so on for sources that
/// cannot be read.
Result<std::unique_ptr<SoundTrack>> openSoundTrack(const FilmOptions &options, bool needsGlobalHeader);

} // namespace ductus
