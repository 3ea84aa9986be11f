// FrameStore: the pictures of a clip for the eye: decoded on a thread of its own, the ones around the present
// frame kept, never more than a fixed amount of memory.
#pragma once

#include "base/error.h"
#include "doodling/clip/clip.h"

#include <QImage>
#include <QObject>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

namespace ductus {

class FrameStore : public QObject
{
    Q_OBJECT
public:
    explicit FrameStore(QObject *parent = nullptr);
    /// Waits for the frame being decoded.
    ~FrameStore() override;

    /// Null: none. Forgets all pictures.
    void setClip(std::shared_ptr<Clip> clip);
    int frameCount() const { return mFrameCount; }

    /// Pictures of at most so many lines; 0: as they are. Forgets all pictures if that is another number;
    /// true then.
    bool setMostLines(int lines);

    /// The picture if it is there, else a null one. Never waits.
    QImage frame(int index) const;
    /// The nearest one that is there, so that scrubbing shows something at once; null if there is none.
    QImage nearest(int index) const;
    /// This one is needed now, then those after it (\a direction > 0) or before it. The newest wish counts.
    void want(int index, int direction);

    /// How many pictures are kept at most.
    int capacity() const;
    int storedCount() const;

signals:
    void frameReady(int index);
    /// A frame could not be decoded; told once a clip.
    void failed(const ductus::Error &error);

private:
    void run();
    int nextWanted() const; // -1: nothing to do
    void keep(int index, QImage picture);
    int distance(int index) const;

    mutable std::mutex mMutex;
    std::condition_variable mWake;
    std::shared_ptr<Clip> mClip;
    std::map<int, QImage> mPictures;
    int mFrameCount = 0;
    int mMostLines = 0;
    int mWanted = -1;
    int mDirection = 1;
    int mGeneration = 0; // of clip and size
    bool mHasFailed = false;
    bool mIsEnding = false;
    std::thread mThread;
};

} // namespace ductus
