// SurfacingJobs: solves the document's content in the background. One job at a time; a newer request replaces
// the running one; cancelling keeps the last result.
#pragma once

#include "document/jobs/job_runner.h"
#include "sketchsurfacer/document/sketch_document.h"

namespace ductus {

class SurfacingJobs : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive this.
    SurfacingJobs(SketchDocument &document, JobRunner &runner, QObject *parent = nullptr);

    /// Solves the present content unless its result is known or being made.
    void start();
    /// Esc: stops and keeps what there was.
    void cancel();
    bool isRunning() const { return mRunningId != 0; }

    /// Whether edits start() by themselves once there was a result.
    bool followsEdits() const { return mFollowsEdits; }
    void setFollowsEdits(bool on) { mFollowsEdits = on; }

signals:
    void runningChanged(bool running);
    void failed(const ductus::Error &error);
    /// Said by the solver about the new result.
    void noticed(const QStringList &warnings);

private:
    void onChanged(const ChangeEvent &event);

    SketchDocument &mDocument;
    JobRunner &mRunner;
    QTimer mFollow;
    quint64 mRunningId = 0; // content being solved
    bool mFollowsEdits = true;
};

} // namespace ductus
