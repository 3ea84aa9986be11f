// FilmPreview: frames with the doodles in them, as the film will show them, hidden parts and all; made on a
// worker, the frame looked at first, the next ones ahead of time.
#pragma once

#include "doodlestudio/ui/canvases/studio_state.h"
#include "doodlestudio/ui/player/frame_store.h"

#include <QThreadPool>
#include <map>

namespace ductus {

class DoodlePainter;

class FilmPreview : public QObject
{
    Q_OBJECT
public:
    FilmPreview(StudioState &state, FrameStore &frames, QObject *parent = nullptr);
    /// Waits for the frame being made.
    ~FilmPreview() override;

    /// The frame as it is now, or as it was before the last edit; null if it was not made yet.
    QImage picture(int frame) const;
    /// Whether picture() is of the present content.
    bool isUpToDate(int frame) const;
    /// Whether there is anything to composite: else the clip's own pictures do.
    bool isNeeded() const;
    /// This frame is looked at now.
    void want(int frame, bool isPlaying);
    /// Pictures of another size come from now on.
    void forget();

signals:
    void ready(int frame);

private:
    struct Made
    {
        QImage picture;
        quint64 version = 0;
    };

    void onLookChanged();
    void startNext();
    int nextWanted() const;

    StudioState &mState;
    FrameStore &mFrames;
    std::map<int, Made> mMade;
    std::shared_ptr<const DoodleScene> mScene;
    std::shared_ptr<const Shot> mShot;
    std::vector<std::shared_ptr<const CanvasTrack>> mTrackPointers;
    std::shared_ptr<const std::vector<CanvasTrack>> mTracks; // in the scene's order
    quint64 mVersion = 1;
    int mWanted = -1;
    bool mIsPlaying = false;
    bool mIsRunning = false;
    std::shared_ptr<const DoodlePainter> mPainter; // used by one thread at a time
    QThreadPool mPool;
};

} // namespace ductus
