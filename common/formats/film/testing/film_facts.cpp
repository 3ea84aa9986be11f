#include "formats/film/testing/film_facts.h"

#include "formats/film/av_handles.h"

extern "C" {
#include <libavutil/pixdesc.h>
}

#include <cmath>
#include <cstdlib>

namespace ductus {

namespace {

Error failed(const std::string &problem, const std::filesystem::path &path)
{
    return {ErrorCode::ReadFailed, "Reading the film back", problem, "", path.string()};
}

Image pictureOf(const AVFrame &frame)
{
    Image image(frame.width, frame.height);
    SwsContext *scaler =
        sws_getContext(frame.width, frame.height, AVPixelFormat(frame.format), frame.width, frame.height,
                       AV_PIX_FMT_RGBA, SWS_BILINEAR | SWS_ACCURATE_RND, nullptr, nullptr, nullptr);
    const int *coefficients =
        sws_getCoefficients(frame.colorspace == AVCOL_SPC_BT709 ? SWS_CS_ITU709 : SWS_CS_DEFAULT);
    sws_setColorspaceDetails(scaler, coefficients, 0, coefficients, 1, 0, 1 << 16, 1 << 16);
    std::uint8_t *const planes[] = {image.pixels.data()};
    const int strides[] = {4 * frame.width};
    sws_scale(scaler, frame.data, frame.linesize, 0, frame.height, planes, strides);
    sws_freeContext(scaler);
    return image;
}

AvOwned<AVCodecContext> decoderOf(const AVStream &stream)
{
    // FFmpeg's own decoder of VP9 does not know transparency.
    const AVCodec *decoder = stream.codecpar->codec_id == AV_CODEC_ID_VP9
                                 ? avcodec_find_decoder_by_name("libvpx-vp9")
                                 : avcodec_find_decoder(stream.codecpar->codec_id);
    AvOwned<AVCodecContext> codec(decoder ? avcodec_alloc_context3(decoder) : nullptr);
    if (!codec || avcodec_parameters_to_context(codec.get(), stream.codecpar) < 0)
        return nullptr;
    codec->pkt_timebase = stream.time_base;
    return avcodec_open2(codec.get(), decoder, nullptr) < 0 ? nullptr : std::move(codec);
}

void takePictures(AVCodecContext &codec, AVFrame &frame, const AVStream &stream, FilmFacts &facts)
{
    while (avcodec_receive_frame(&codec, &frame) >= 0) {
        facts.frames.push_back(pictureOf(frame));
        facts.frameTimes.push_back(double(frame.best_effort_timestamp) * av_q2d(stream.time_base));
        facts.pixelFormat = av_get_pix_fmt_name(AVPixelFormat(frame.format));
        facts.isBt709 = frame.colorspace == AVCOL_SPC_BT709 && frame.color_primaries == AVCOL_PRI_BT709 &&
                        frame.color_trc == AVCOL_TRC_BT709;
    }
}

void takeSound(AVCodecContext &codec, AVFrame &frame, FilmFacts &facts)
{
    while (avcodec_receive_frame(&codec, &frame) >= 0) {
        facts.soundRate = frame.sample_rate;
        for (int i = 0; i < frame.nb_samples; ++i) {
            if (frame.format == AV_SAMPLE_FMT_FLTP)
                facts.sound.push_back(reinterpret_cast<const float *>(frame.extended_data[0])[i]);
            else if (frame.format == AV_SAMPLE_FMT_S16)
                facts.sound.push_back(float(reinterpret_cast<const std::int16_t *>(
                                          frame.extended_data[0])[i * frame.ch_layout.nb_channels]) /
                                      32768.0f);
        }
    }
}

} // namespace

Result<FilmFacts> filmFacts(const std::filesystem::path &path)
{
    av_log_set_level(AV_LOG_QUIET);
    AVFormatContext *opened = nullptr;
    if (avformat_open_input(&opened, path.c_str(), nullptr, nullptr) < 0)
        return failed("it is no film", path);
    const AvOwned<AVFormatContext> format(opened);
    if (avformat_find_stream_info(opened, nullptr) < 0)
        return failed("its streams cannot be told", path);
    FilmFacts facts;
    facts.seconds = double(opened->duration) / AV_TIME_BASE;
    const int video = av_find_best_stream(opened, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    const int sound = av_find_best_stream(opened, AVMEDIA_TYPE_AUDIO, -1, -1, nullptr, 0);
    if (video < 0)
        return failed("there are no pictures in it", path);
    const AVStream &pictures = *opened->streams[video];
    facts.videoCodec = avcodec_get_name(pictures.codecpar->codec_id);
    facts.width = pictures.codecpar->width;
    facts.height = pictures.codecpar->height;
    facts.rateNumerator = pictures.avg_frame_rate.num;
    facts.rateDenominator = pictures.avg_frame_rate.den;
    const AvOwned<AVCodecContext> videoCodec = decoderOf(pictures);
    const AvOwned<AVCodecContext> soundCodec = sound >= 0 ? decoderOf(*opened->streams[sound]) : nullptr;
    const AvOwned<AVPacket> packet(av_packet_alloc());
    const AvOwned<AVFrame> frame(av_frame_alloc());
    if (!videoCodec || (sound >= 0 && !soundCodec))
        return failed("there is no decoder for it", path);
    if (sound >= 0)
        facts.soundCodec = avcodec_get_name(opened->streams[sound]->codecpar->codec_id);
    double soundEnds = 0.0;
    bool isFirstSound = true;
    while (av_read_frame(opened, packet.get()) >= 0) {
        if (packet->stream_index == video) {
            avcodec_send_packet(videoCodec.get(), packet.get());
            takePictures(*videoCodec, *frame, pictures, facts);
        } else if (packet->stream_index == sound) {
            const double unit = av_q2d(opened->streams[sound]->time_base);
            if (isFirstSound)
                facts.soundBegins = double(packet->pts) * unit;
            isFirstSound = false;
            soundEnds = double(packet->pts + packet->duration) * unit;
            avcodec_send_packet(soundCodec.get(), packet.get());
            takeSound(*soundCodec, *frame, facts);
        }
        av_packet_unref(packet.get());
    }
    avcodec_send_packet(videoCodec.get(), nullptr);
    takePictures(*videoCodec, *frame, pictures, facts);
    if (soundCodec) {
        avcodec_send_packet(soundCodec.get(), nullptr);
        takeSound(*soundCodec, *frame, facts);
        facts.soundSeconds = soundEnds - facts.soundBegins;
    }
    return facts;
}

double meanDifference(const Image &a, const Image &b)
{
    if (a.width != b.width || a.height != b.height || a.pixels.empty())
        return 255.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        if (i % 4 != 3)
            sum += std::abs(int(a.pixels[i]) - int(b.pixels[i]));
    return sum / (0.75 * double(a.pixels.size()));
}

} // namespace ductus
