#include "doodlestudio/ui/player/frame_store.h"

#include <algorithm>
#include <climits>

namespace ductus {

namespace {

constexpr double mostBytes = 320e6;
constexpr int fewestPictures = 8;

// The clip's memory is gone when this returns: the picture owns its own.
QImage decodedPicture(const Image &image)
{
    const QImage view(image.pixels.data(), image.width, image.height, image.width * 4,
                      QImage::Format_RGBA8888);
    return view.convertToFormat(QImage::Format_RGB32);
}

} // namespace

FrameStore::FrameStore(QObject *parent) : QObject(parent), mThread([this] { run(); }) {}

FrameStore::~FrameStore()
{
    {
        const std::lock_guard lock(mMutex);
        mIsEnding = true;
    }
    mWake.notify_all();
    mThread.join();
}

void FrameStore::setClip(std::shared_ptr<Clip> clip)
{
    {
        const std::lock_guard lock(mMutex);
        mFrameCount = clip ? clip->info().frameCount : 0;
        mClip = std::move(clip);
        mPictures.clear();
        mWanted = -1;
        mHasFailed = false;
        ++mGeneration;
    }
    mWake.notify_all();
}

bool FrameStore::setMostLines(int lines)
{
    const std::lock_guard lock(mMutex);
    if (lines == mMostLines)
        return false;
    mMostLines = lines;
    mPictures.clear();
    ++mGeneration;
    mWake.notify_all();
    return true;
}

QImage FrameStore::frame(int index) const
{
    const std::lock_guard lock(mMutex);
    const auto found = mPictures.find(index);
    return found == mPictures.end() ? QImage() : found->second;
}

QImage FrameStore::nearest(int index) const
{
    const std::lock_guard lock(mMutex);
    if (mPictures.empty())
        return {};
    const auto after = mPictures.lower_bound(index);
    if (after == mPictures.begin())
        return after->second;
    const auto before = std::prev(after);
    if (after == mPictures.end() || index - before->first < after->first - index)
        return before->second;
    return after->second;
}

void FrameStore::want(int index, int direction)
{
    {
        const std::lock_guard lock(mMutex);
        if (index < 0 || index >= mFrameCount)
            return;
        mWanted = index;
        mDirection = direction < 0 ? -1 : 1;
    }
    mWake.notify_all();
}

int FrameStore::capacity() const
{
    const std::lock_guard lock(mMutex);
    if (!mClip)
        return 0;
    const auto [width, height] = scaledSize(mClip->info().width, mClip->info().height, mMostLines);
    return std::max(fewestPictures, int(mostBytes / (4.0 * width * height)));
}

int FrameStore::storedCount() const
{
    const std::lock_guard lock(mMutex);
    return int(mPictures.size());
}

// Frames to go from the wanted one in the present direction, the clip taken as a loop.
int FrameStore::distance(int index) const
{
    const int way = (index - mWanted) * mDirection;
    return way < 0 ? way + mFrameCount : way;
}

int FrameStore::nextWanted() const
{
    if (!mClip || mWanted < 0)
        return -1;
    if (!mPictures.contains(mWanted))
        return mWanted;
    const auto [width, height] = scaledSize(mClip->info().width, mClip->info().height, mMostLines);
    const int most = std::max(fewestPictures, int(mostBytes / (4.0 * width * height)));
    // A fifth of the room is for what was just seen: stepping back is as quick as stepping on.
    const int ahead = std::min(mFrameCount, most - most / 5);
    for (int i = 1; i < ahead; ++i) {
        const int index = ((mWanted + i * mDirection) % mFrameCount + mFrameCount) % mFrameCount;
        if (!mPictures.contains(index))
            return index;
    }
    return -1;
}

void FrameStore::keep(int index, QImage picture)
{
    const auto [width, height] = scaledSize(mClip->info().width, mClip->info().height, mMostLines);
    const auto most = std::size_t(std::max(fewestPictures, int(mostBytes / (4.0 * width * height))));
    mPictures[index] = std::move(picture);
    const int reach = std::max(1, int(most) / 5);
    while (mPictures.size() > most) {
        auto furthest = mPictures.begin();
        int worst = -1;
        for (auto it = mPictures.begin(); it != mPictures.end(); ++it) {
            const int ahead = distance(it->first);
            const int behind = mFrameCount - ahead;
            const int badness = behind <= reach ? 0 : ahead;
            if (badness > worst) {
                worst = badness;
                furthest = it;
            }
        }
        mPictures.erase(furthest);
    }
}

void FrameStore::run()
{
    std::unique_lock lock(mMutex);
    for (;;) {
        mWake.wait(lock, [this] { return mIsEnding || nextWanted() >= 0; });
        if (mIsEnding)
            return;
        const int index = nextWanted();
        const int generation = mGeneration;
        const int lines = mMostLines;
        const std::shared_ptr<Clip> clip = mClip;
        lock.unlock();
        Result<Image> image = clip->frame(index, lines);
        QImage picture = image ? decodedPicture(*image) : QImage();
        lock.lock();
        if (generation != mGeneration)
            continue;
        if (!image) {
            // A hole is shown as its neighbour: a black flash would say more than is wrong.
            const bool isFirst = !mHasFailed;
            mHasFailed = true;
            picture = mPictures.empty() ? QImage(16, 9, QImage::Format_RGB32) : mPictures.begin()->second;
            if (isFirst)
                QMetaObject::invokeMethod(
                    this, [this, error = image.error()] { emit failed(error); }, Qt::QueuedConnection);
        }
        keep(index, std::move(picture));
        QMetaObject::invokeMethod(
            this, [this, index] { emit frameReady(index); }, Qt::QueuedConnection);
    }
}

} // namespace ductus
