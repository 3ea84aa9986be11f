#include "formats/film/video_encoder.h"

#include "formats/film/filled_colours.h"

#include <cstring>

namespace ductus {

namespace {

constexpr char attempted[] = "Writing the film";

Error failed(ErrorCode code, const std::string &problem, const std::string &remedy = "")
{
    return {code, attempted, problem, remedy, ""};
}

// Odd sides grown to even ones by repeating the last column and row.
Image evenSided(const Image &image)
{
    const int width = (image.width + 1) / 2 * 2, height = (image.height + 1) / 2 * 2;
    Image result(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            result.set(x, y, image.at(std::min(x, image.width - 1), std::min(y, image.height - 1)));
    return result;
}

void setOptions(AVCodecContext &codec, const FilmOptions &options)
{
    const bool isMp4 = options.kind == FilmKind::Mp4;
    const int quality = options.quality > 0 ? options.quality : isMp4 ? 18 : 28;
    av_opt_set_int(&codec, "crf", quality, AV_OPT_SEARCH_CHILDREN);
    if (isMp4) {
        av_opt_set(codec.priv_data, "preset", "faster", 0);
        return;
    }
    codec.bit_rate = 0; // constant quality
    av_opt_set(codec.priv_data, "deadline", "good", 0);
    av_opt_set_int(codec.priv_data, "cpu-used", 5, 0);
    av_opt_set_int(codec.priv_data, "row-mt", 1, 0);
    av_opt_set_int(codec.priv_data, "tile-columns", 2, 0);
    if (options.keepsAlpha) // libvpx refuses transparency together with hidden frames
        av_opt_set_int(codec.priv_data, "auto-alt-ref", 0, 0);
}

} // namespace

Result<VideoEncoder> VideoEncoder::open(const FilmOptions &options, bool needsGlobalHeader)
{
    const bool isMp4 = options.kind == FilmKind::Mp4;
    const char *name = isMp4 ? "libx264" : "libvpx-vp9";
    const AVCodec *found = avcodec_find_encoder_by_name(name);
    if (!found)
        return failed(
            ErrorCode::Unsupported,
            std::string("this computer's FFmpeg has no encoder for ") +
                (isMp4 ? "H.264 (libx264)" : "VP9 (libvpx)"),
            "Install a complete FFmpeg (Debian: libavcodec59 or libavcodec-extra59), or choose another "
            "kind of film, such as GIF or pictures");
    VideoEncoder encoder;
    encoder.mCodec.reset(avcodec_alloc_context3(found));
    encoder.mFrame.reset(av_frame_alloc());
    encoder.mPacket.reset(av_packet_alloc());
    if (!encoder.mCodec || !encoder.mFrame || !encoder.mPacket)
        return failed(ErrorCode::TooLarge, "there is not enough memory");
    AVCodecContext &codec = *encoder.mCodec;
    codec.width = isMp4 ? (options.width + 1) / 2 * 2 : options.width;
    codec.height = isMp4 ? (options.height + 1) / 2 * 2 : options.height;
    codec.pix_fmt = options.keepsAlpha ? AV_PIX_FMT_YUVA420P : AV_PIX_FMT_YUV420P;
    codec.framerate = {options.rate.numerator, options.rate.denominator};
    codec.time_base = options.frameTimes.empty() ? av_inv_q(codec.framerate) : AVRational{1, 90000};
    if (!options.frameTimes.empty())
        codec.max_b_frames =
            0; // frames stored out of order leave MP4 with a wrong length where steps are uneven
    codec.sample_aspect_ratio = {1, 1};
    codec.color_range = AVCOL_RANGE_MPEG;
    codec.colorspace = AVCOL_SPC_BT709;
    codec.color_primaries = AVCOL_PRI_BT709;
    codec.color_trc = AVCOL_TRC_BT709;
    codec.gop_size = std::max(12, int(2.0 * options.rate.perSecond())); // players seek to every second one
    codec.thread_count = 0;
    if (needsGlobalHeader)
        codec.flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    setOptions(codec, options);
    if (const int code = avcodec_open2(&codec, found, nullptr); code < 0)
        return failed(ErrorCode::Unsupported,
                      "the encoder " + std::string(name) + " does not take it (" + avMessage(code) + ")",
                      "Choose a smaller size or another kind of film");
    encoder.mFrame->format = codec.pix_fmt;
    encoder.mFrame->width = codec.width;
    encoder.mFrame->height = codec.height;
    encoder.mFrame->color_range = codec.color_range;
    encoder.mFrame->colorspace = codec.colorspace;
    if (const int code = av_frame_get_buffer(encoder.mFrame.get(), 0); code < 0)
        return failed(ErrorCode::TooLarge, "there is not enough memory (" + avMessage(code) + ")");
    encoder.mScaler.reset(
        sws_getContext(codec.width, codec.height, AV_PIX_FMT_RGBA, codec.width, codec.height, codec.pix_fmt,
                       SWS_AREA | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP, nullptr, nullptr, nullptr));
    if (!encoder.mScaler)
        return failed(ErrorCode::Unsupported, "pictures cannot be converted for the encoder");
    const int *coefficients = sws_getCoefficients(SWS_CS_ITU709);
    sws_setColorspaceDetails(encoder.mScaler.get(), coefficients, 1, coefficients, 0, 0, 1 << 16, 1 << 16);
    return encoder;
}

Result<void> VideoEncoder::convert(const Image &image)
{
    if (const int code = av_frame_make_writable(mFrame.get()); code < 0)
        return failed(ErrorCode::TooLarge, "there is not enough memory (" + avMessage(code) + ")");
    const std::uint8_t *const planes[] = {image.pixels.data()};
    const int strides[] = {image.width * 4};
    sws_scale(mScaler.get(), planes, strides, 0, image.height, mFrame->data, mFrame->linesize);
    return {};
}

Result<void> VideoEncoder::add(const Image &image, std::int64_t time, std::int64_t duration, const Take &take)
{
    const bool fits = image.width == mCodec->width && image.height == mCodec->height;
    const bool isClear = mCodec->pix_fmt == AV_PIX_FMT_YUVA420P;
    Result<void> converted = isClear ? convert(withFilledColours(image))
                             : fits  ? convert(image)
                                     : convert(evenSided(image));
    if (!converted)
        return converted;
    mFrame->pts = time;
    mFrame->pkt_duration = duration;
    if (const int code = avcodec_send_frame(mCodec.get(), mFrame.get()); code < 0)
        return failed(ErrorCode::WriteFailed, "a frame cannot be encoded (" + avMessage(code) + ")");
    return drain(take);
}

Result<void> VideoEncoder::finish(const Take &take)
{
    if (const int code = avcodec_send_frame(mCodec.get(), nullptr); code < 0)
        return failed(ErrorCode::WriteFailed, "the film cannot be ended (" + avMessage(code) + ")");
    return drain(take);
}

Result<void> VideoEncoder::drain(const Take &take)
{
    for (;;) {
        const int code = avcodec_receive_packet(mCodec.get(), mPacket.get());
        if (code == AVERROR(EAGAIN) || code == AVERROR_EOF)
            return {};
        if (code < 0)
            return failed(ErrorCode::WriteFailed, "a frame cannot be encoded (" + avMessage(code) + ")");
        if (Result<void> taken = take(*mPacket); !taken)
            return taken;
    }
}

} // namespace ductus
