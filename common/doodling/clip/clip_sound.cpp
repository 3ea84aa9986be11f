#include "doodling/clip/clip_sound.h"

#include "formats/film/av_handles.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr char attempted[] = "Reading the sound of the clip";

Error failed(ErrorCode code, const std::string &problem, const std::filesystem::path &path)
{
    return {code, attempted, problem, "The pictures can be used without it", path.string()};
}

// One sample of a decoded frame, -1..1.
double sampleAt(const AVFrame &frame, int index, int channel, int channels)
{
    const auto format = AVSampleFormat(frame.format);
    const bool isPlanar = av_sample_fmt_is_planar(format) != 0;
    const std::uint8_t *plane = frame.extended_data[isPlanar ? channel : 0];
    const int at = isPlanar ? index : index * channels + channel;
    switch (av_get_packed_sample_fmt(format)) {
    case AV_SAMPLE_FMT_U8:
        return (double(plane[at]) - 128.0) / 128.0;
    case AV_SAMPLE_FMT_S16:
        return double(reinterpret_cast<const std::int16_t *>(plane)[at]) / 32768.0;
    case AV_SAMPLE_FMT_S32:
        return double(reinterpret_cast<const std::int32_t *>(plane)[at]) / 2147483648.0;
    case AV_SAMPLE_FMT_FLT:
        return double(reinterpret_cast<const float *>(plane)[at]);
    case AV_SAMPLE_FMT_DBL:
        return reinterpret_cast<const double *>(plane)[at];
    default:
        return 0.0;
    }
}

std::int16_t asInteger(double sample)
{
    // NaN in a broken stream is silence
    return sample == sample ? std::int16_t(std::lround(std::clamp(sample, -1.0, 1.0) * 32767.0))
                            : std::int16_t(0);
}

void append(const AVFrame &frame, ClipSound &sound)
{
    const int channels = frame.ch_layout.nb_channels;
    for (int i = 0; i < frame.nb_samples; ++i) {
        if (channels <= 2) {
            for (int c = 0; c < channels; ++c)
                sound.samples.push_back(asInteger(sampleAt(frame, i, c, channels)));
            continue;
        }
        // Odd ones left, even ones right: near enough to listen to while drawing.
        double sides[2] = {0.0, 0.0};
        for (int c = 0; c < channels; ++c)
            sides[c % 2] += sampleAt(frame, i, c, channels) / ((channels + 1 - c % 2) / 2);
        sound.samples.push_back(asInteger(sides[0]));
        sound.samples.push_back(asInteger(sides[1]));
    }
}

double startOf(const AVFormatContext &format, int index)
{
    const auto seconds = [&](int stream) {
        const AVStream &s = *format.streams[stream];
        return s.start_time == AV_NOPTS_VALUE ? 0.0 : double(s.start_time) * av_q2d(s.time_base);
    };
    const int video =
        av_find_best_stream(const_cast<AVFormatContext *>(&format), AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    return video < 0 ? 0.0 : seconds(index) - seconds(video);
}

} // namespace

double ClipSound::durationSeconds() const
{
    return sampleRate > 0 && channels > 0 ? double(samples.size()) / channels / sampleRate : 0.0;
}

double ClipSound::peak(double fromSeconds, double toSeconds) const
{
    if (sampleRate <= 0 || channels <= 0)
        return 0.0;
    const auto count = double(samples.size() / std::size_t(channels));
    const auto from = std::size_t(std::clamp((fromSeconds - startSeconds) * sampleRate, 0.0, count));
    const auto to = std::size_t(std::clamp((toSeconds - startSeconds) * sampleRate, 0.0, count));
    int loudest = 0;
    for (std::size_t i = from * std::size_t(channels); i < to * std::size_t(channels); ++i)
        loudest = std::max(loudest, std::abs(int(samples[i])));
    return std::min(1.0, loudest / 32767.0);
}

Result<ClipSound> readSound(const std::filesystem::path &path, const SoundOptions &options,
                            const JobControl &control)
{
    std::error_code failure;
    if (std::filesystem::is_directory(path, failure))
        return ClipSound{};
    if (!std::filesystem::exists(path, failure))
        return failed(ErrorCode::FileNotFound, "the file is not there", path);
    av_log_set_level(AV_LOG_QUIET); // what is wrong is told by our errors
    AVFormatContext *opened = nullptr;
    if (const int code = avformat_open_input(&opened, path.c_str(), nullptr, nullptr); code < 0)
        return failed(ErrorCode::Unsupported, "it is no video file (" + avMessage(code) + ")", path);
    AvOwned<AVFormatContext> format(opened);
    if (avformat_find_stream_info(format.get(), nullptr) < 0)
        return failed(ErrorCode::Malformed, "its streams cannot be told", path);
    const AVCodec *decoder = nullptr;
    const int index = av_find_best_stream(format.get(), AVMEDIA_TYPE_AUDIO, -1, -1, &decoder, 0);
    if (index < 0)
        return ClipSound{};
    AvOwned<AVCodecContext> codec(avcodec_alloc_context3(decoder));
    if (!decoder || !codec ||
        avcodec_parameters_to_context(codec.get(), format->streams[index]->codecpar) < 0 ||
        avcodec_open2(codec.get(), decoder, nullptr) < 0)
        return failed(ErrorCode::Unsupported, "there is no decoder for its sound", path);

    ClipSound sound;
    sound.startSeconds = startOf(*format, index);
    const double duration = format->duration > 0 ? double(format->duration) / AV_TIME_BASE : 0.0;
    AvOwned<AVPacket> packet(av_packet_alloc());
    AvOwned<AVFrame> frame(av_frame_alloc());
    bool isAtEnd = false;
    while (!isAtEnd) {
        if (control.isCancelled())
            return cancelledError(attempted);
        const int code = av_read_frame(format.get(), packet.get());
        isAtEnd = code < 0;
        if (isAtEnd)
            avcodec_send_packet(codec.get(), nullptr);
        else if (packet->stream_index == index)
            avcodec_send_packet(codec.get(), packet.get()); // broken packets make no sound, later ones may
        av_packet_unref(packet.get());
        while (avcodec_receive_frame(codec.get(), frame.get()) >= 0) {
            if (frame->ch_layout.nb_channels < 1 || frame->sample_rate < 1)
                continue;
            if (sound.sampleRate == 0) {
                sound.sampleRate = frame->sample_rate;
                sound.channels = std::min(frame->ch_layout.nb_channels, 2);
            }
            // A stream that changes its kind midway cannot be one sound.
            if (frame->sample_rate == sound.sampleRate &&
                std::min(frame->ch_layout.nb_channels, 2) == sound.channels)
                append(*frame, sound);
        }
        if (duration > 0.0)
            control.progress(std::min(1.0, sound.durationSeconds() / duration), attempted);
        isAtEnd = isAtEnd || sound.durationSeconds() > options.longestSeconds;
    }
    return sound;
}

} // namespace ductus
