#include "doodling/clip/frame_picture.h"
#include "doodling/clip/open_clip.h"
#include "doodling/clip/video_stream.h"

#include <algorithm>

namespace ductus {

namespace {

class VideoClip : public Clip
{
public:
    VideoClip(VideoStream video, std::vector<std::int64_t> times, ClipInfo info, std::filesystem::path path)
        : mVideo(std::move(video)), mTimes(std::move(times)), mInfo(std::move(info)), mPath(std::move(path))
    {
    }

    const ClipInfo &info() const override { return mInfo; }

    Result<Image> frame(int index, int mostLines) override
    {
        if (index < 0 || index >= mInfo.frameCount)
            return missing(index);
        const std::int64_t wanted = mTimes[std::size_t(index)];
        // A short way ahead it is cheaper to go on than to jump back to a key frame.
        if (index < mNext || index > mNext + 30)
            mVideo.seek(wanted);
        while (const AVFrame *decoded = mVideo.next()) {
            const std::int64_t time = timeOf(*decoded);
            if (time < wanted)
                continue;
            mNext = int(std::upper_bound(mTimes.begin(), mTimes.end(), time) - mTimes.begin());
            return mPicture.make(*decoded, mInfo.rotationDegrees,
                                 mostLines); // a later one where this is broken
        }
        mNext = mInfo.frameCount;
        return missing(index);
    }

private:
    static std::int64_t timeOf(const AVFrame &frame)
    {
        return frame.best_effort_timestamp != AV_NOPTS_VALUE ? frame.best_effort_timestamp : frame.pts;
    }
    Error missing(int index) const
    {
        return {ErrorCode::ReadFailed, "Reading the clip",
                "frame " + std::to_string(index) + " cannot be decoded",
                "Cut the clip before this frame, or convert it to MP4 (H.264)", mPath.string()};
    }

    VideoStream mVideo;
    std::vector<std::int64_t> mTimes;
    ClipInfo mInfo;
    std::filesystem::path mPath;
    FramePicture mPicture;
    int mNext = 0; // the frame VideoStream::next gives
};

// Frames listed but not decodable at the end of a cut file do not count. How many are left, from the last key
// frame on.
int decodableCount(VideoStream &video, const std::vector<std::int64_t> &times)
{
    video.seek(times.back());
    std::int64_t last = AV_NOPTS_VALUE;
    while (const AVFrame *frame = video.next())
        last = std::max(last, frame->best_effort_timestamp);
    if (last == AV_NOPTS_VALUE) { // nothing after the last key frame: look from the start
        video.seek(times.front());
        while (const AVFrame *frame = video.next())
            last = std::max(last, frame->best_effort_timestamp);
    }
    video.seek(times.front());
    return last == AV_NOPTS_VALUE ? 0
                                  : int(std::upper_bound(times.begin(), times.end(), last) - times.begin());
}

bool hasAudio(const AVFormatContext &format)
{
    for (unsigned i = 0; i < format.nb_streams; ++i)
        if (format.streams[i]->codecpar->codec_type == AVMEDIA_TYPE_AUDIO)
            return true;
    return false;
}

} // namespace

Result<std::unique_ptr<Clip>> openVideo(const std::filesystem::path &path, const JobControl &control)
{
    control.progress(0.0, "Opening the clip");
    Result<VideoStream> video = VideoStream::open(path);
    if (!video)
        return video.error();
    ClipInfo info;
    bool isCut = false;
    std::vector<std::int64_t> times = video->readTimes(&isCut);
    if (control.isCancelled())
        return cancelledError("Opening the clip");
    const int listed = int(times.size());
    info.frameCount = times.empty() ? 0 : decodableCount(*video, times);
    if (info.frameCount == 0)
        return Error{ErrorCode::Malformed, "Opening the clip", "no frame in it can be decoded",
                     "Choose another file, or convert it to MP4 (H.264)", path.string()};
    times.resize(std::size_t(info.frameCount));
    if (isCut || info.frameCount < listed)
        info.warnings.push_back("The file is cut off; " + std::to_string(info.frameCount) +
                                " frames can be used.");
    const double unit = av_q2d(video->stream().time_base);
    for (std::int64_t time : times)
        info.frameTimes.push_back(double(time - times.front()) * unit);
    info.rotationDegrees = video->rotationDegrees();
    const AVCodecParameters &codec = *video->stream().codecpar;
    info.width = info.rotationDegrees % 180 ? codec.height : codec.width;
    info.height = info.rotationDegrees % 180 ? codec.width : codec.height;
    info.codec = avcodec_get_name(codec.codec_id);
    info.hasAudio = hasAudio(video->format());
    const double announced = av_q2d(video->stream().avg_frame_rate);
    info.framesPerSecond = info.frameCount > 1 ? (info.frameCount - 1) / info.frameTimes.back()
                           : announced > 0.0   ? announced
                                               : 24.0;
    return std::unique_ptr<Clip>(
        std::make_unique<VideoClip>(std::move(*video), std::move(times), std::move(info), path));
}

} // namespace ductus
