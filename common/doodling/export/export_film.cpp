#include "doodling/export/export_film.h"

#include "base/parallel.h"
#include "doodling/compositing/doodle_painter.h"
#include "doodling/export/depth_picture.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr char attempted[] = "Exporting the film";
constexpr int framesAtOnce = 4; // drawn in parallel; also what is in memory

// Which frames of the clip the film shows, and when.
struct Schedule
{
    std::vector<int> frames;
    FrameRate rate;
    std::vector<double> times; // empty: evenly
};

Schedule scheduleOf(const ClipInfo &info, int everyNth)
{
    Schedule schedule;
    std::vector<double> times;
    for (int t = 0; t < info.frameCount; t += std::max(1, everyNth)) {
        schedule.frames.push_back(t);
        times.push_back(std::size_t(t) < info.frameTimes.size() ? info.frameTimes[std::size_t(t)]
                                                                : t / info.framesPerSecond);
    }
    schedule.rate = frameRateNear(info.framesPerSecond / std::max(1, everyNth));
    if (const std::optional<FrameRate> even = evenFrameRate(times))
        schedule.rate = *even;
    else if (times.size() > 1)
        schedule.times = std::move(times);
    return schedule;
}

class Exporter
{
public:
    Exporter(Clip &clip, const Shot &shot, const DoodleScene &scene, std::vector<CanvasTrack> tracks,
             const FilmExport &what)
        : mClip(clip), mShot(shot), mScene(scene), mTracks(std::move(tracks)), mWhat(what)
    {
        if (what.content == ExportContent::Depth)
            mRange = disparityRange(shot);
    }

    // Pictures of the clip one after another: decoders go forwards.
    Result<std::vector<Image>> decoded(const std::vector<int> &frames, ExportReport &report)
    {
        std::vector<Image> pictures;
        for (const int t : frames) {
            Result<Image> picture = mClip.frame(t, mWhat.mostLines);
            if (!picture && mLast.pixels.empty())
                return picture.error();
            if (!picture)
                report.warnings.push_back("Frame " + std::to_string(t) +
                                          " cannot be decoded; the one before is shown");
            else
                mLast = std::move(*picture);
            pictures.push_back(mLast);
        }
        return pictures;
    }

    Image drawn(int frame, const Image &picture) const
    {
        const DoodleMoment moment{mShot, mScene, mTracks, frame};
        switch (mWhat.content) {
        case ExportContent::Composite:
            return mPainter.composited(moment, picture);
        case ExportContent::Doodle:
            return mPainter.alone(moment, picture);
        case ExportContent::Depth:
            return depthPicture(mShot, frame, mRange, picture.width, picture.height);
        }
        return picture;
    }

private:
    Clip &mClip;
    const Shot &mShot;
    const DoodleScene &mScene;
    std::vector<CanvasTrack> mTracks;
    const FilmExport &mWhat;
    DisparityRange mRange;
    DoodlePainter mPainter;
    Image mLast;
};

FilmOptions filmOptions(const FilmExport &what, const Schedule &schedule, const ClipInfo &info,
                        const std::filesystem::path &clipPath)
{
    FilmOptions options;
    options.kind = what.kind;
    std::tie(options.width, options.height) = scaledSize(info.width, info.height, what.mostLines);
    options.rate = schedule.rate;
    options.frameTimes = schedule.times;
    options.keepsAlpha = what.content == ExportContent::Doodle && what.kind != FilmKind::Mp4;
    options.background = what.background;
    options.quality = what.quality;
    const bool hasSound = what.kind == FilmKind::Mp4 || what.kind == FilmKind::WebM;
    if (what.withSound && info.hasAudio && hasSound)
        options.soundFrom = clipPath;
    return options;
}

} // namespace

Result<std::vector<CanvasTrack>> tracksOf(const Shot &shot, const DoodleScene &scene,
                                          const JobControl &control)
{
    std::vector<CanvasTrack> tracks;
    for (std::size_t i = 0; i < scene.canvases.size(); ++i) {
        const double count = double(scene.canvases.size());
        const JobControl part = control.part(double(i) / count, double(i + 1) / count);
        part.progress(0.0, "Following the canvases");
        if (!scene.canvases[i].isVisible) { // nobody sees where it would be
            tracks.emplace_back();
            continue;
        }
        Result<CanvasTrack> track = canvasTrack(shot, scene.canvases[i], part.silenced());
        if (!track)
            return track.error();
        tracks.push_back(std::move(*track));
    }
    return tracks;
}

Result<ExportReport> exportFilm(Clip &clip, const std::filesystem::path &clipPath, const Shot &shot,
                                const DoodleScene &scene, const FilmExport &what,
                                const std::filesystem::path &output, const JobControl &control)
{
    const ClipInfo &info = clip.info();
    if (shot.frameCount() != info.frameCount)
        return Error{ErrorCode::InvalidArgument, attempted,
                     "the scene was made of " + std::to_string(shot.frameCount()) +
                         " frames and the clip has " + std::to_string(info.frameCount),
                     "Find out anew how the clip moves (analyse)", clipPath.string()};
    if (what.everyNth < 1)
        return Error{ErrorCode::InvalidArgument, attempted, "every 0th frame is none", "", ""};
    Result<std::vector<CanvasTrack>> tracks = tracksOf(shot, scene, control.part(0.0, 0.05));
    if (!tracks)
        return tracks.error();
    const Schedule schedule = scheduleOf(info, what.everyNth);
    const FilmOptions options = filmOptions(what, schedule, info, clipPath);
    Result<FilmWriter> film = FilmWriter::open(output, options);
    if (!film)
        return film.error();
    ExportReport report{
        0, options.width, options.height, schedule.rate, schedule.times.empty(), !options.soundFrom.empty(),
        {}};
    Exporter exporter(clip, shot, scene, std::move(*tracks), what);
    const std::size_t count = schedule.frames.size();
    for (std::size_t first = 0; first < count; first += framesAtOnce) {
        if (control.isCancelled())
            return cancelledError(attempted);
        control.progress(0.05 + 0.94 * double(first) / double(count), attempted);
        const std::size_t end = std::min(count, first + framesAtOnce);
        const std::vector<int> frames(schedule.frames.begin() + std::ptrdiff_t(first),
                                      schedule.frames.begin() + std::ptrdiff_t(end));
        Result<std::vector<Image>> pictures = exporter.decoded(frames, report);
        if (!pictures)
            return pictures.error();
        parallelFor(0, frames.size(),
                    [&](std::size_t i) { (*pictures)[i] = exporter.drawn(frames[i], (*pictures)[i]); });
        for (const Image &picture : *pictures) {
            if (control.isCancelled())
                return cancelledError(attempted);
            if (Result<void> added = film->add(picture); !added)
                return added.error();
        }
    }
    if (control.isCancelled())
        return cancelledError(attempted);
    if (Result<void> ended = film->finish(); !ended)
        return ended.error();
    report.frames = film->frameCount();
    control.progress(1.0, "Done");
    return report;
}

} // namespace ductus
