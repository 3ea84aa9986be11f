// Animated GIFs through libavformat, with palettes of our own.
#include "formats/film/av_handles.h"
#include "formats/film/film_container.h"
#include "formats/film/film_sinks.h"
#include "formats/film/gif_palette.h"
#include "formats/film/output_place.h"

#include <cmath>
#include <cstring>

namespace ductus {

namespace {

constexpr char attempted[] = "Writing the film";
constexpr int ticksASecond = 100;
constexpr int shortestTicks = 2; // players show shorter frames for 1/10 s

class Gif : public FilmSink
{
public:
    Gif(OutputPlace place, FilmOptions options, std::filesystem::path target)
        : mOptions(std::move(options)), mTarget(std::move(target)), mPlace(std::move(place))
    {
    }

    Result<void> open();
    Result<void> add(const Image &image) override;
    Result<void> finish() override;

private:
    Result<void> drain();
    void choosePalette(const Image &image);
    std::int64_t ticksOf(int frame) const;

    FilmOptions mOptions;
    std::filesystem::path mTarget; // for words
    OutputPlace mPlace;
    FilmContainer mContainer; // after mPlace
    AvOwned<AVCodecContext> mCodec;
    AvOwned<AVPacket> mPacket;
    std::optional<GifPalette> mPalette;
    double mPaletteError = 0.0; // on the picture it was made of
    int mCount = 0;
    std::int64_t mLast = -shortestTicks; // the last frame shown
};

Result<void> Gif::open()
{
    const AVCodec *encoder = avcodec_find_encoder(AV_CODEC_ID_GIF);
    AVFormatContext *container = nullptr;
    if (!encoder || avformat_alloc_output_context2(&container, nullptr, "gif", mPlace.path().c_str()) < 0)
        return Error{ErrorCode::Unsupported, attempted, "this computer's FFmpeg cannot write GIF",
                     "Install a complete FFmpeg (Debian: libavcodec59 and libavformat59)", ""};
    mContainer.reset(container);
    mCodec.reset(avcodec_alloc_context3(encoder));
    mPacket.reset(av_packet_alloc());
    AVStream *stream = avformat_new_stream(container, nullptr);
    if (!mCodec || !mPacket || !stream)
        return filmWriteError("there is not enough memory", AVERROR(ENOMEM), mTarget);
    mCodec->width = mOptions.width;
    mCodec->height = mOptions.height;
    mCodec->pix_fmt = AV_PIX_FMT_PAL8;
    mCodec->time_base = {1, ticksASecond};
    if (const int code = avcodec_open2(mCodec.get(), encoder, nullptr); code < 0)
        return filmWriteError("its encoder cannot be opened", code, mTarget);
    stream->time_base = mCodec->time_base;
    if (const int code = avcodec_parameters_from_context(stream->codecpar, mCodec.get()); code < 0)
        return filmWriteError("its encoder cannot be described", code, mTarget);
    if (const int code = avio_open(&container->pb, mPlace.path().c_str(), AVIO_FLAG_WRITE); code < 0)
        return filmWriteError("it cannot be opened for writing", code, mTarget);
    // Of the last frame; the others last until the next one.
    av_opt_set_int(
        container->priv_data, "final_delay",
        std::max<std::int64_t>(shortestTicks, std::llround(ticksASecond / mOptions.rate.perSecond())), 0);
    if (const int code = avformat_write_header(container, nullptr); code < 0)
        return filmWriteError("its begin cannot be written", code, mTarget);
    return {};
}

std::int64_t Gif::ticksOf(int frame) const
{
    const double seconds = mOptions.frameTimes.empty()
                               ? frame / mOptions.rate.perSecond()
                               : mOptions.frameTimes[std::size_t(frame)] - mOptions.frameTimes.front();
    return std::llround(seconds * ticksASecond);
}

// While the colours stay much the same the palette stays: what does not move then costs nothing, and does not
// flicker.
void Gif::choosePalette(const Image &image)
{
    constexpr double slack = 1.3, least = 6.0; // squared levels
    if (mPalette && mPalette->error(image) <= slack * mPaletteError + least)
        return;
    mPalette = GifPalette::of(image);
    mPaletteError = mPalette->error(image);
}

Result<void> Gif::add(const Image &image)
{
    const std::int64_t time = ticksOf(mCount++);
    if (time - mLast < shortestTicks)
        return {};
    mLast = time;
    choosePalette(image);
    const std::vector<std::uint8_t> indices = mPalette->indices(image);
    const AvOwned<AVFrame> frame(av_frame_alloc());
    if (!frame)
        return filmWriteError("there is not enough memory", AVERROR(ENOMEM), mTarget);
    frame->format = AV_PIX_FMT_PAL8;
    frame->width = image.width;
    frame->height = image.height;
    frame->pts = time;
    if (const int code = av_frame_get_buffer(frame.get(), 0); code < 0)
        return filmWriteError("there is not enough memory", code, mTarget);
    for (int y = 0; y < image.height; ++y)
        std::memcpy(frame->data[0] + std::ptrdiff_t(y) * frame->linesize[0],
                    indices.data() + std::size_t(y) * std::size_t(image.width), std::size_t(image.width));
    std::memcpy(frame->data[1], mPalette->colours().data(), sizeof mPalette->colours());
    if (const int code = avcodec_send_frame(mCodec.get(), frame.get()); code < 0)
        return filmWriteError("a frame cannot be encoded", code, mTarget);
    return drain();
}

Result<void> Gif::drain()
{
    while (avcodec_receive_packet(mCodec.get(), mPacket.get()) >= 0) {
        mPacket->stream_index = 0;
        av_packet_rescale_ts(mPacket.get(), mCodec->time_base, mContainer->streams[0]->time_base);
        if (const int code = av_interleaved_write_frame(mContainer.get(), mPacket.get()); code < 0)
            return filmWriteError("a part of it cannot be written", code, mTarget);
    }
    return {};
}

Result<void> Gif::finish()
{
    avcodec_send_frame(mCodec.get(), nullptr);
    if (Result<void> drained = drain(); !drained)
        return drained;
    if (const int code = av_write_trailer(mContainer.get()); code < 0)
        return filmWriteError("its end cannot be written", code, mTarget);
    if (const int code = avio_closep(&mContainer->pb); code < 0)
        return filmWriteError("its end cannot be written", code, mTarget);
    return mPlace.commit();
}

} // namespace

Result<std::unique_ptr<FilmSink>> openGif(const std::filesystem::path &path, const FilmOptions &options)
{
    av_log_set_level(AV_LOG_QUIET);
    Result<OutputPlace> place = OutputPlace::beside(path, OutputPlace::Kind::File);
    if (!place)
        return place.error();
    auto gif = std::make_unique<Gif>(std::move(*place), options, path);
    if (Result<void> opened = gif->open(); !opened)
        return opened.error();
    return std::unique_ptr<FilmSink>(std::move(gif));
}

} // namespace ductus
