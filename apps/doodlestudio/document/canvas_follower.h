// CanvasFollower: where every canvas is in every frame, kept up with the document's edits. Following runs on
// a worker, one at a time for a canvas: while a keyframe is dragged each result is shown as it comes, and the
// last edit always wins.
#pragma once

#include "document/jobs/job_runner.h"
#include "doodlestudio/document/doodle_document.h"

#include <QObject>
#include <map>
#include <optional>

namespace ductus {

class CanvasFollower : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive this.
    CanvasFollower(DoodleDocument &document, JobRunner &runner, QObject *parent = nullptr);

    /// Null as long as it was never followed. Perhaps of the edit before: see isUpToDate().
    std::shared_ptr<const CanvasTrack> track(CanvasId id) const;
    std::optional<CanvasFrame> place(CanvasId id, int frame) const;
    bool isUpToDate(CanvasId id) const;
    bool isBusy() const;
    /// Milliseconds the last following of a moving canvas took, on the worker.
    double lastMilliseconds() const { return mLastMilliseconds; }

signals:
    void trackChanged(ductus::CanvasId id);

private:
    struct Followed
    {
        Canvas wanted; // placement as of the last edit; its drawings are left out
        std::shared_ptr<const Shot> wantedShot;
        int wantedVersion = 0;
        int doneVersion = -1;
        bool isRunning = false;
        std::shared_ptr<const CanvasTrack> track;
    };

    void onChanged(const ChangeEvent &event);
    void follow(CanvasId id);
    void finish(CanvasId id, int version, Result<CanvasTrack> track);

    DoodleDocument &mDocument;
    JobRunner &mRunner;
    std::map<CanvasId, Followed> mFollowed;
    double mLastMilliseconds = 0.0;
    int mGeneration = 0; // of the document's content
};

/// Whether both are in the same places: what is drawn does not matter.
bool isPlacedAlike(const Canvas &a, const Canvas &b);

} // namespace ductus
