#include "doodling/reconstruction/shot_motion.h"

#include "base/parallel.h"
#include "doodling/reconstruction/frame_records.h"
#include "doodling/reconstruction/motion_reader.h"

namespace ductus {

namespace {

constexpr char attempted[] = "Finding how the scene moves";

struct KeptMotion
{
    FrameMotion motion;
    std::shared_ptr<const MappedFile> file; // null: in memory
};

std::optional<KeptMotion> takeFrame(ShotStore &store, int frame, int frameCount)
{
    std::shared_ptr<const MappedFile> file = store.read(RecordKind::Motion, frame);
    if (!file)
        return std::nullopt;
    RecordReader reader(file);
    std::optional<FrameMotion> motion = motionFrom(reader);
    std::vector<int> gaps;
    if (motion)
        for (const auto &[gap, flows] : motion->longFlows)
            gaps.push_back(gap);
    if (!motion || motion->forward.isEmpty() != (frame == 0) || gaps != longGapsTo(frame, frameCount)) {
        store.refuse(RecordKind::Motion, frame);
        return std::nullopt;
    }
    return KeptMotion{std::move(*motion), std::move(file)};
}

Result<KeptMotion> kept(ShotStore *store, int frame, FrameMotion motion)
{
    if (!store)
        return KeptMotion{std::move(motion), nullptr};
    Result<std::shared_ptr<const MappedFile>> file =
        store->write(RecordKind::Motion, frame, recordOf(motion));
    if (!file)
        return file.error();
    RecordReader reader(*file);
    std::optional<FrameMotion> mapped = motionFrom(reader);
    DUCTUS_ASSERT(mapped);
    return KeptMotion{std::move(*mapped), std::move(*file)};
}

void put(KeptMotion frame, int t, Shot &shot)
{
    shot.width = frame.motion.width;
    shot.height = frame.motion.height;
    shot.pictures.push_back(std::move(frame.motion.picture));
    if (t > 0) {
        shot.forward.push_back(std::move(frame.motion.forward));
        shot.backward.push_back(std::move(frame.motion.backward));
    }
    for (auto &[gap, flows] : frame.motion.longFlows)
        shot.longFlows[{t - gap, gap}] = std::move(flows);
    if (frame.file)
        shot.motionFiles.push_back(std::move(frame.file));
}

} // namespace

bool takeMotion(ShotStore &store, int frameCount, Shot &shot)
{
    Shot taken;
    for (int t = 0; t < frameCount; ++t) {
        std::optional<KeptMotion> frame = takeFrame(store, t, frameCount);
        if (!frame)
            return false;
        frame->file->forgetPages(); // its sum was looked at
        put(std::move(*frame), t, taken);
    }
    shot.width = taken.width;
    shot.height = taken.height;
    shot.pictures = std::move(taken.pictures);
    shot.forward = std::move(taken.forward);
    shot.backward = std::move(taken.backward);
    shot.longFlows = std::move(taken.longFlows);
    shot.motionFiles = std::move(taken.motionFiles);
    return true;
}

Result<std::vector<PointTrack>> findMotion(Clip &clip, const ShotOptions &options, ShotStore *store,
                                           Shot &shot, const JobControl &control)
{
    const int frames = clip.info().frameCount;
    PointTracker tracker;
    MotionReader reader(frames, options.flow);
    for (int t = 0; t < frames; ++t) {
        if (control.isCancelled())
            return cancelledError(attempted);
        control.progress(double(t) / frames, attempted);
        Result<Image> image = clip.frame(t, options.mostLines);
        if (!image)
            return image.error();
        std::optional<KeptMotion> frame;
        if (store)
            frame = takeFrame(*store, t, frames);
        if (frame) {
            reader.pass(*image);
        } else {
            Result<KeptMotion> made = kept(store, t, reader.add(*image));
            if (!made)
                return made.error();
            frame = std::move(*made);
            if (options.report)
                ++options.report->motionsMade;
        }
        put(std::move(*frame), t, shot);
        tracker.add(*image, t > 0 ? &shot.forward.back() : nullptr);
        shot.forgetPages(t, t);
    }
    return tracker.takeTracks();
}

} // namespace ductus
