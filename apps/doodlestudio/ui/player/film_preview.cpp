#include "doodlestudio/ui/player/film_preview.h"

#include "doodling/compositing/doodle_painter.h"

#include <algorithm>
#include <cstring>

namespace ductus {

namespace {

constexpr int aheadPlaying = 30, aheadStanding = 4; // frames

Image imageOf(const QImage &picture)
{
    const QImage rgba = picture.convertToFormat(QImage::Format_RGBA8888);
    Image image(rgba.width(), rgba.height());
    for (int y = 0; y < rgba.height(); ++y)
        std::memcpy(image.pixels.data() + std::size_t(y) * std::size_t(image.width) * 4,
                    rgba.constScanLine(y), std::size_t(image.width) * 4);
    return image;
}

QImage pictureOf(const Image &image)
{
    const QImage view(image.pixels.data(), image.width, image.height, image.width * 4,
                      QImage::Format_RGBA8888);
    return view.convertToFormat(QImage::Format_RGB32);
}

} // namespace

FilmPreview::FilmPreview(StudioState &state, FrameStore &frames, QObject *parent)
    : QObject(parent), mState(state), mFrames(frames), mPainter(std::make_shared<const DoodlePainter>())
{
    mPool.setMaxThreadCount(1);
    connect(&state, &StudioState::lookChanged, this, &FilmPreview::onLookChanged);
    connect(&frames, &FrameStore::frameReady, this, &FilmPreview::startNext);
}

FilmPreview::~FilmPreview()
{
    mPool.waitForDone();
}

QImage FilmPreview::picture(int frame) const
{
    const auto found = mMade.find(frame);
    return found == mMade.end() ? QImage() : found->second.picture;
}

bool FilmPreview::isUpToDate(int frame) const
{
    const auto found = mMade.find(frame);
    return found != mMade.end() && found->second.version == mVersion;
}

bool FilmPreview::isNeeded() const
{
    const auto &canvases = mState.document().scene().canvases;
    return std::any_of(canvases.begin(), canvases.end(), [](const Canvas &canvas) {
        return canvas.prop || std::any_of(canvas.doodle.frames.begin(), canvas.doodle.frames.end(),
                                          [](const DoodleFrame &frame) { return !frame.marks.empty(); });
    });
}

void FilmPreview::forget()
{
    mMade.clear();
    ++mVersion;
    startNext();
}

void FilmPreview::want(int frame, bool isPlaying)
{
    mWanted = frame;
    mIsPlaying = isPlaying;
    startNext();
}

void FilmPreview::onLookChanged()
{
    const std::shared_ptr<const DoodleScene> scene = mState.document().sharedScene();
    std::vector<std::shared_ptr<const CanvasTrack>> tracks;
    for (const Canvas &canvas : scene->canvases)
        tracks.push_back(mState.follower().track(canvas.id));
    if (scene == mScene && tracks == mTrackPointers)
        return;
    auto values = std::make_shared<std::vector<CanvasTrack>>();
    for (const auto &track : tracks)
        values->push_back(track ? *track : CanvasTrack());
    mScene = scene;
    mTrackPointers = std::move(tracks);
    mTracks = std::move(values);
    mShot = mState.document().isEmpty() ? nullptr : mState.document().sceneShot();
    ++mVersion;
    // All but the one that is seen are of no use any more.
    std::erase_if(mMade, [this](const auto &made) { return made.first != mWanted; });
    startNext();
}

int FilmPreview::nextWanted() const
{
    const int count = mFrames.frameCount();
    if (mWanted < 0 || mWanted >= count)
        return -1;
    const int ahead = std::min({count, mFrames.capacity() / 2, mIsPlaying ? aheadPlaying : aheadStanding});
    for (int i = 0; i < std::max(1, ahead); ++i) {
        const int frame = (mWanted + i) % count;
        if (!isUpToDate(frame))
            return mFrames.frame(frame).isNull() ? -1 : frame;
    }
    return -1;
}

void FilmPreview::startNext()
{
    if (mIsRunning || !mScene || !mShot || !isNeeded())
        return;
    const int frame = nextWanted();
    if (frame < 0 || frame >= mShot->frameCount())
        return;
    mIsRunning = true;
    mPool.start([this, frame, version = mVersion, scene = mScene, shot = mShot, tracks = mTracks,
                 painter = mPainter, picture = mFrames.frame(frame)] {
        const DoodleMoment moment{*shot, *scene, *tracks, frame};
        const QImage made = pictureOf(painter->composited(moment, imageOf(picture)));
        // The destructor waits for this thread: the object is still there when this is posted.
        QMetaObject::invokeMethod(
            this,
            [this, frame, version, made] {
                mIsRunning = false;
                const bool isOfNow = version == mVersion;
                if (isOfNow || frame == mWanted)
                    mMade[frame] = {made, version};
                // What was shown longest ago goes first.
                const int most = std::max(8, mFrames.capacity() / 2);
                while (int(mMade.size()) > most) {
                    auto furthest =
                        std::max_element(mMade.begin(), mMade.end(), [this](const auto &a, const auto &b) {
                            const int n = std::max(1, mFrames.frameCount());
                            return (a.first - mWanted + n) % n < (b.first - mWanted + n) % n;
                        });
                    mMade.erase(furthest);
                }
                if (isOfNow || frame == mWanted)
                    emit ready(frame);
                startNext();
            },
            Qt::QueuedConnection);
    });
}

} // namespace ductus
