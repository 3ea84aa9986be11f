#include "formats/film/sound_source.h"

namespace ductus {

namespace {

constexpr char attempted[] = "Reading the sound";

Error failed(const std::string &problem, const std::filesystem::path &path)
{
    return {ErrorCode::Unsupported, attempted, problem,
            "Export without sound, or check the film it comes from", path.string()};
}

// The presentation time of the first video frame, or where the file begins.
double videoBegin(AVFormatContext &format, AVPacket &packet)
{
    const int video = av_find_best_stream(&format, AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    const double fileBegin =
        format.start_time != AV_NOPTS_VALUE ? double(format.start_time) / AV_TIME_BASE : 0.0;
    if (video < 0)
        return fileBegin;
    const AVStream &stream = *format.streams[video];
    if (stream.start_time != AV_NOPTS_VALUE)
        return double(stream.start_time) * av_q2d(stream.time_base);
    std::int64_t first = AV_NOPTS_VALUE;
    for (int seen = 0; seen < 32 && av_read_frame(&format, &packet) >= 0;) {
        if (packet.stream_index == video) {
            ++seen; // with frames that are shown later than they come
            if (packet.pts != AV_NOPTS_VALUE && (first == AV_NOPTS_VALUE || packet.pts < first))
                first = packet.pts;
        }
        av_packet_unref(&packet);
    }
    av_seek_frame(&format, -1, format.start_time != AV_NOPTS_VALUE ? format.start_time : 0,
                  AVSEEK_FLAG_BACKWARD);
    return first == AV_NOPTS_VALUE ? fileBegin : double(first) * av_q2d(stream.time_base);
}

} // namespace

Result<std::optional<SoundSource>> SoundSource::open(const std::filesystem::path &path,
                                                     std::optional<double> begins)
{
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) // a clip of pictures
        return std::optional<SoundSource>();
    if (!std::filesystem::exists(path, error))
        return Error{ErrorCode::FileNotFound, attempted, "there is no such file", "Check the path",
                     path.string()};
    SoundSource source;
    AVFormatContext *format = nullptr;
    if (const int code = avformat_open_input(&format, path.c_str(), nullptr, nullptr); code < 0)
        return failed("it is no film (" + avMessage(code) + ")", path);
    source.mFormat.reset(format);
    if (const int code = avformat_find_stream_info(format, nullptr); code < 0)
        return failed("its streams cannot be told (" + avMessage(code) + ")", path);
    source.mIndex = av_find_best_stream(format, AVMEDIA_TYPE_AUDIO, -1, -1, nullptr, 0);
    if (source.mIndex < 0)
        return std::optional<SoundSource>();
    source.mPacket.reset(av_packet_alloc());
    source.mBegins = begins ? *begins : videoBegin(*format, *source.mPacket);
    return std::optional<SoundSource>(std::move(source));
}

AVPacket *SoundSource::next()
{
    av_packet_unref(mPacket.get());
    while (av_read_frame(mFormat.get(), mPacket.get()) >= 0) {
        if (mPacket->stream_index == mIndex)
            return mPacket.get();
        av_packet_unref(mPacket.get());
    }
    return nullptr;
}

} // namespace ductus
