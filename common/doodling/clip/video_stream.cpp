#include "doodling/clip/video_stream.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr char attempted[] = "Opening the clip";
constexpr char remedy[] = "Choose a video that a player on this computer can show, or a folder of pictures";

Error failed(ErrorCode code, const std::string &problem, const std::filesystem::path &path)
{
    return {code, attempted, problem, remedy, path.string()};
}

} // namespace

Result<VideoStream> VideoStream::open(const std::filesystem::path &path)
{
    av_log_set_level(AV_LOG_QUIET); // what is wrong is told by our errors
    VideoStream video;
    AVFormatContext *format = nullptr;
    if (const int code = avformat_open_input(&format, path.c_str(), nullptr, nullptr); code < 0)
        return failed(ErrorCode::Unsupported, "it is no video file (" + avMessage(code) + ")", path);
    video.mFormat.reset(format);
    if (const int code = avformat_find_stream_info(format, nullptr); code < 0)
        return failed(ErrorCode::Malformed, "its streams cannot be told (" + avMessage(code) + ")", path);
    const AVCodec *decoder = nullptr;
    video.mIndex = av_find_best_stream(format, AVMEDIA_TYPE_VIDEO, -1, -1, &decoder, 0);
    if (video.mIndex < 0 || !decoder)
        return failed(ErrorCode::Unsupported, "there is no video in it that can be decoded", path);
    video.mCodec.reset(avcodec_alloc_context3(decoder));
    if (!video.mCodec ||
        avcodec_parameters_to_context(video.mCodec.get(), format->streams[video.mIndex]->codecpar) < 0)
        return failed(ErrorCode::Malformed, "its decoder cannot be set up", path);
    video.mCodec->thread_count = 2;
    if (const int code = avcodec_open2(video.mCodec.get(), decoder, nullptr); code < 0)
        return failed(ErrorCode::Unsupported, "its decoder cannot be opened (" + avMessage(code) + ")", path);
    video.mPacket.reset(av_packet_alloc());
    video.mFrame.reset(av_frame_alloc());
    return video;
}

int VideoStream::rotationDegrees() const
{
    const std::uint8_t *matrix = av_stream_get_side_data(&stream(), AV_PKT_DATA_DISPLAYMATRIX, nullptr);
    if (!matrix)
        return 0;
    const double counterClockwise = av_display_rotation_get(reinterpret_cast<const std::int32_t *>(matrix));
    if (!std::isfinite(counterClockwise))
        return 0;
    const int clockwise = int(std::lround(-counterClockwise / 90.0)) * 90;
    return ((clockwise % 360) + 360) % 360;
}

std::vector<std::int64_t> VideoStream::readTimes(bool *isCut)
{
    std::vector<std::int64_t> times;
    int code = 0;
    while ((code = av_read_frame(mFormat.get(), mPacket.get())) >= 0) {
        if (mPacket->stream_index == mIndex && !(mPacket->flags & AV_PKT_FLAG_DISCARD)) {
            const std::int64_t time = mPacket->pts != AV_NOPTS_VALUE ? mPacket->pts : mPacket->dts;
            if (time != AV_NOPTS_VALUE)
                times.push_back(time);
            if (mPacket->flags & AV_PKT_FLAG_CORRUPT)
                *isCut = true;
        }
        av_packet_unref(mPacket.get());
    }
    *isCut = *isCut || code != AVERROR_EOF;
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (!times.empty())
        seek(times.front());
    return times;
}

AVFrame *VideoStream::next()
{
    for (;;) {
        const int code = avcodec_receive_frame(mCodec.get(), mFrame.get());
        if (code >= 0)
            return mFrame.get();
        if (code != AVERROR(EAGAIN))
            return nullptr;
        if (mIsDraining)
            return nullptr;
        if (av_read_frame(mFormat.get(), mPacket.get()) < 0) {
            mIsDraining = true;
            avcodec_send_packet(mCodec.get(), nullptr);
            continue;
        }
        if (mPacket->stream_index == mIndex)
            avcodec_send_packet(mCodec.get(), mPacket.get()); // broken packets make no frame, later ones may
        av_packet_unref(mPacket.get());
    }
}

bool VideoStream::seek(std::int64_t time)
{
    mIsDraining = false;
    const bool isDone = av_seek_frame(mFormat.get(), mIndex, time, AVSEEK_FLAG_BACKWARD) >= 0;
    avcodec_flush_buffers(mCodec.get());
    return isDone;
}

} // namespace ductus
