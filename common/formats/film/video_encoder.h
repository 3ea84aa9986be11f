// From pictures to packets of H.264 or VP9, 8 bit 4:2:0 in BT.709.
#pragma once

#include "formats/film/av_handles.h"
#include "formats/film/film_writer.h"

#include <functional>

namespace ductus {

class VideoEncoder
{
public:
    using Take = std::function<Result<void>(AVPacket &)>;

    /// \a needsGlobalHeader: as the container wants it. Unsupported where the encoder is not installed.
    static Result<VideoEncoder> open(const FilmOptions &options, bool needsGlobalHeader);

    const AVCodecContext &codec() const { return *mCodec; }

    /// Time stamps and durations of the packets given to \a take are in codec().time_base.
    Result<void> add(const Image &image, std::int64_t time, std::int64_t duration, const Take &take);
    Result<void> finish(const Take &take);

private:
    VideoEncoder() = default;
    Result<void> drain(const Take &take);
    Result<void> convert(const Image &image);

    AvOwned<AVCodecContext> mCodec;
    AvOwned<AVFrame> mFrame;
    AvOwned<AVPacket> mPacket;
    AvOwned<SwsContext> mScaler;
};

} // namespace ductus
