// MP4 and WebM through libavformat.
#include "formats/film/film_container.h"
#include "formats/film/film_sinks.h"
#include "formats/film/output_place.h"
#include "formats/film/sound_track.h"
#include "formats/film/video_encoder.h"

#include <cmath>
#include <map>

namespace ductus {

namespace {

class Movie : public FilmSink
{
public:
    Movie(OutputPlace place, FilmOptions options, std::filesystem::path target)
        : mOptions(std::move(options)), mTarget(std::move(target)), mPlace(std::move(place))
    {
    }

    Result<void> open();
    Result<void> add(const Image &image) override;
    Result<void> finish() override;

private:
    Result<void> addStreams();
    Result<void> write(AVPacket &packet, AVRational timeBase, int stream);
    Result<void> writePicture(AVPacket &packet);
    Result<void> advanceSound(double seconds);
    double timeOf(int frame) const;
    double endOf(int frame) const;
    std::int64_t ticksOf(int frame, double seconds) const;

    FilmOptions mOptions;
    std::filesystem::path mTarget; // for words
    OutputPlace mPlace;
    FilmContainer mContainer; // after mPlace
    std::optional<VideoEncoder> mVideo;
    std::unique_ptr<SoundTrack> mSound;              // null: silent
    std::map<std::int64_t, std::int64_t> mDurations; // by time stamp, of frames in the encoder
    int mCount = 0;
};

Result<void> Movie::open()
{
    AVFormatContext *container = nullptr;
    const char *name = mOptions.kind == FilmKind::Mp4 ? "mp4" : "webm";
    if (const int code = avformat_alloc_output_context2(&container, nullptr, name, mPlace.path().c_str());
        code < 0)
        return filmWriteError(std::string("this computer's FFmpeg cannot write ") + name, code, mTarget);
    mContainer.reset(container);
    if (Result<void> added = addStreams(); !added)
        return added;
    if (const int code = avio_open(&container->pb, mPlace.path().c_str(), AVIO_FLAG_WRITE); code < 0)
        return filmWriteError("it cannot be opened for writing", code, mTarget);
    AVDictionary *settings = nullptr;
    if (mOptions.kind == FilmKind::Mp4) // players can begin before all of it has arrived
        av_dict_set(&settings, "movflags", "+faststart", 0);
    const int code = avformat_write_header(container, &settings);
    av_dict_free(&settings);
    return code < 0 ? Result<void>(filmWriteError("its begin cannot be written", code, mTarget)) : Result<void>();
}

Result<void> Movie::addStreams()
{
    const bool needsGlobalHeader = mContainer->oformat->flags & AVFMT_GLOBALHEADER;
    Result<VideoEncoder> video = VideoEncoder::open(mOptions, needsGlobalHeader);
    if (!video)
        return video.error();
    mVideo.emplace(std::move(*video));
    Result<std::unique_ptr<SoundTrack>> sound = openSoundTrack(mOptions, needsGlobalHeader);
    if (!sound)
        return sound.error();
    mSound = std::move(*sound);
    AVStream *picture = avformat_new_stream(mContainer.get(), nullptr);
    AVStream *audio = mSound ? avformat_new_stream(mContainer.get(), nullptr) : nullptr;
    if (!picture || (mSound && !audio) ||
        avcodec_parameters_from_context(picture->codecpar, &mVideo->codec()) < 0 ||
        (audio && avcodec_parameters_copy(audio->codecpar, &mSound->parameters()) < 0))
        return filmWriteError("there is not enough memory", AVERROR(ENOMEM), mTarget);
    picture->time_base = mVideo->codec().time_base;
    picture->sample_aspect_ratio = {1, 1};
    if (mOptions.frameTimes.empty())
        picture->avg_frame_rate = mVideo->codec().framerate;
    if (mOptions.keepsAlpha) // told to players by this note only
        av_dict_set(&picture->metadata, "alpha_mode", "1", 0);
    if (audio) {
        audio->time_base = mSound->timeBase();
        audio->codecpar->codec_tag = 0; // of the other container
    }
    return {};
}

double Movie::timeOf(int frame) const
{
    return mOptions.frameTimes.empty()
               ? frame / mOptions.rate.perSecond()
               : mOptions.frameTimes[std::size_t(frame)] - mOptions.frameTimes.front();
}

double Movie::endOf(int frame) const
{
    const bool isLast = std::size_t(frame) + 1 >= mOptions.frameTimes.size();
    return isLast ? timeOf(frame) + 1.0 / mOptions.rate.perSecond() : timeOf(frame + 1);
}

std::int64_t Movie::ticksOf(int frame, double seconds) const
{
    return mOptions.frameTimes.empty() ? frame : std::llround(seconds / av_q2d(mVideo->codec().time_base));
}

Result<void> Movie::write(AVPacket &packet, AVRational timeBase, int stream)
{
    av_packet_rescale_ts(&packet, timeBase, mContainer->streams[stream]->time_base);
    packet.stream_index = stream;
    packet.pos = -1;
    if (const int code = av_interleaved_write_frame(mContainer.get(), &packet); code < 0)
        return filmWriteError("a part of it cannot be written", code, mTarget);
    return {};
}

// Encoders forget how long a frame lasts; without it the last one has no length and the film is short.
Result<void> Movie::writePicture(AVPacket &packet)
{
    if (const auto found = mDurations.find(packet.pts); found != mDurations.end()) {
        packet.duration = found->second;
        mDurations.erase(found);
    }
    return write(packet, mVideo->codec().time_base, 0);
}

Result<void> Movie::advanceSound(double seconds)
{
    if (!mSound)
        return {};
    return mSound->advance(seconds, [&](AVPacket &p) { return write(p, mSound->timeBase(), 1); });
}

Result<void> Movie::add(const Image &image)
{
    const int frame = mCount++;
    const std::int64_t begin = ticksOf(frame, timeOf(frame));
    const std::int64_t end = ticksOf(frame + 1, endOf(frame));
    mDurations[begin] = end - begin;
    const auto take = [&](AVPacket &packet) { return writePicture(packet); };
    if (Result<void> added = mVideo->add(image, begin, end - begin, take); !added)
        return added;
    return advanceSound(endOf(frame));
}

Result<void> Movie::finish()
{
    const int last = mCount - 1;
    const auto take = [&](AVPacket &packet) { return writePicture(packet); };
    if (Result<void> ended = mVideo->finish(take); !ended)
        return ended;
    if (Result<void> sounded = advanceSound(endOf(last)); !sounded)
        return sounded;
    if (mSound)
        if (Result<void> ended = mSound->finish([&](AVPacket &p) { return write(p, mSound->timeBase(), 1); });
            !ended)
            return ended;
    if (const int code = av_write_trailer(mContainer.get()); code < 0)
        return filmWriteError("its end cannot be written", code, mTarget);
    if (const int code = avio_closep(&mContainer->pb); code < 0)
        return filmWriteError("its end cannot be written", code, mTarget);
    return mPlace.commit();
}

} // namespace

Result<std::unique_ptr<FilmSink>> openMovie(const std::filesystem::path &path, const FilmOptions &options)
{
    av_log_set_level(AV_LOG_QUIET); // what is wrong is told by our errors
    Result<OutputPlace> place = OutputPlace::beside(path, OutputPlace::Kind::File);
    if (!place)
        return place.error();
    auto movie = std::make_unique<Movie>(std::move(*place), options, path);
    if (Result<void> opened = movie->open(); !opened)
        return opened.error();
    return std::unique_ptr<FilmSink>(std::move(movie));
}

} // namespace ductus
