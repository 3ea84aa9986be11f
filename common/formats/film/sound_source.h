// The packets of a film's sound, on a clock that starts where the new film does.
#pragma once

#include "base/result.h"
#include "formats/film/av_handles.h"

#include <filesystem>
#include <optional>

namespace ductus {

class SoundSource
{
public:
    /// Null pointer inside if there is no sound in the file. \a begins as FilmOptions::soundBegins.
    static Result<std::optional<SoundSource>> open(const std::filesystem::path &path,
                                                   std::optional<double> begins);

    const AVStream &stream() const { return *mFormat->streams[mIndex]; }
    /// Seconds on the source's clock at which the new film begins.
    double begins() const { return mBegins; }

    /// The next packet of sound, null at the end (or where the file is broken off). Its times are in the
    /// stream's time base and on the source's clock.
    AVPacket *next();

private:
    SoundSource() = default;

    AvOwned<AVFormatContext> mFormat;
    AvOwned<AVPacket> mPacket;
    int mIndex = -1;
    double mBegins = 0.0;
};

} // namespace ductus
