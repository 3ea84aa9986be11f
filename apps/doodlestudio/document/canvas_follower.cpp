#include "doodlestudio/document/canvas_follower.h"

#include <QElapsedTimer>
#include <algorithm>

namespace ductus {

namespace {

template <typename T, typename Same>
bool isAlike(const std::vector<T> &a, const std::vector<T> &b, Same same)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

Canvas placementOf(const Canvas &canvas)
{
    Canvas placement = canvas;
    placement.doodle = {};
    placement.occlusion.touches.clear();
    return placement;
}

struct TimedTrack
{
    CanvasTrack track;
    double milliseconds = 0.0;
};

} // namespace

bool isPlacedAlike(const Canvas &a, const Canvas &b)
{
    const CanvasKeyframes &k = a.keyframes, &l = b.keyframes;
    return a.motion == b.motion && a.turning == b.turning &&
           isAlike(k.positions, l.positions,
                   [](const CanvasKeyframe &x, const CanvasKeyframe &y) {
                       return x.frame == y.frame && x.pixel == y.pixel && x.depth == y.depth &&
                              x.interpolatesNext == y.interpolatesNext;
                   }) &&
           isAlike(k.depths, l.depths,
                   [](const DepthKeyframe &x, const DepthKeyframe &y) {
                       return x.frame == y.frame && x.depth == y.depth;
                   }) &&
           isAlike(k.turns, l.turns,
                   [](const TurnKeyframe &x, const TurnKeyframe &y) {
                       return x.frame == y.frame && x.interpolatesNext == y.interpolatesNext &&
                              x.worldFromCanvas.coeffs() == y.worldFromCanvas.coeffs();
                   }) &&
           isAlike(k.scales, l.scales, [](const ScaleKeyframe &x, const ScaleKeyframe &y) {
               return x.frame == y.frame && x.scale == y.scale;
           });
}

CanvasFollower::CanvasFollower(DoodleDocument &document, JobRunner &runner, QObject *parent)
    : QObject(parent), mDocument(document), mRunner(runner)
{
    connect(&document, &Document::changed, this, &CanvasFollower::onChanged);
}

std::shared_ptr<const CanvasTrack> CanvasFollower::track(CanvasId id) const
{
    const auto found = mFollowed.find(id);
    return found == mFollowed.end() ? nullptr : found->second.track;
}

std::optional<CanvasFrame> CanvasFollower::place(CanvasId id, int frame) const
{
    const std::shared_ptr<const CanvasTrack> known = track(id);
    if (!known || frame < 0 || frame >= int(known->frames.size()))
        return std::nullopt;
    return known->frames[std::size_t(frame)];
}

bool CanvasFollower::isUpToDate(CanvasId id) const
{
    const auto found = mFollowed.find(id);
    return found != mFollowed.end() && found->second.doneVersion == found->second.wantedVersion;
}

bool CanvasFollower::isBusy() const
{
    return std::any_of(mFollowed.begin(), mFollowed.end(), [](const auto &followed) {
        return followed.second.doneVersion != followed.second.wantedVersion;
    });
}

void CanvasFollower::onChanged(const ChangeEvent &event)
{
    if (event.as<DocumentReset>()) {
        mFollowed.clear();
        ++mGeneration;
    }
    if (mDocument.isEmpty())
        return;
    const std::shared_ptr<const Shot> shot = mDocument.sceneShot();
    for (const Canvas &canvas : mDocument.scene().canvases) {
        const bool isNew = !mFollowed.contains(canvas.id);
        Followed &followed = mFollowed[canvas.id];
        if (!isNew && followed.wantedShot == shot && isPlacedAlike(followed.wanted, canvas))
            continue;
        followed.wanted = placementOf(canvas);
        followed.wantedShot = shot;
        ++followed.wantedVersion;
        if (!followed.isRunning)
            follow(canvas.id);
    }
    // Those of deleted canvases stay: undo brings them back.
}

void CanvasFollower::follow(CanvasId id)
{
    Followed &followed = mFollowed[id];
    const int version = followed.wantedVersion;
    // Standing canvases, and what no flow is known for, cost nothing: at once, so that a drag does not lag.
    if (followed.wanted.motion == CanvasMotion::Static || followed.wantedShot->forward.empty()) {
        Canvas still = followed.wanted;
        if (still.motion == CanvasMotion::Dynamic && followed.wantedShot->frameCount() > 1)
            still.motion = CanvasMotion::Static;
        finish(id, version, canvasTrack(*followed.wantedShot, still, {}));
        return;
    }
    followed.isRunning = true;
    mRunner.start<TimedTrack>(
        {QStringLiteral("follow/%1/%2").arg(mGeneration).arg(id.value), tr("Following the canvas"), true},
        this,
        [canvas = followed.wanted,
         shot = followed.wantedShot](const JobControl &control) -> Result<TimedTrack> {
            QElapsedTimer timer;
            timer.start();
            Result<CanvasTrack> track = canvasTrack(*shot, canvas, control);
            if (!track)
                return track.error();
            return TimedTrack{std::move(*track), double(timer.nsecsElapsed()) * 1e-6};
        },
        [this, id, version, generation = mGeneration](Result<TimedTrack> track) {
            if (generation != mGeneration)
                return;
            mFollowed[id].isRunning = false;
            if (track) {
                mLastMilliseconds = track->milliseconds;
                finish(id, version, std::move(track->track));
            } else {
                finish(id, version, track.error());
            }
        });
}

void CanvasFollower::finish(CanvasId id, int version, Result<CanvasTrack> track)
{
    Followed &followed = mFollowed[id];
    followed.doneVersion = version;
    if (track)
        followed.track = std::make_shared<const CanvasTrack>(std::move(*track));
    else if (!track.error().isCancelled())
        emit mDocument.refused(track.error());
    if (followed.wantedVersion != version && !followed.isRunning)
        follow(id);
    emit trackChanged(id);
}

} // namespace ductus
