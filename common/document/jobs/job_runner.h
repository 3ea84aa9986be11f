// JobRunner: long work on worker threads, told about on the UI thread.
//
//     runner.start<Surface>({"surface", tr("Surfacing")}, work, [this](Result<Surface> result) { ... });
//
// `work` runs on a worker and must own what it reads. `finish` runs on the thread of the runner, exactly once
// for every job that was started; cancelled and replaced jobs finish with a Cancelled error whatever the work
// returned, so the previous result stays. Only the runner's destructor drops finishes: it cancels and waits;
// and those whose receiver is gone are dropped.
#pragma once

#include "base/job_control.h"
#include "base/result.h"

#include <QElapsedTimer>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace ductus {

using JobId = int; // > 0

struct JobSpec
{
    QString key;           // jobs with the same key replace each other; empty: independent of all others
    QString title;         // "Surfacing the sketch"
    bool isQuiet = false;  // not shown to the user: autosave, thumbnails
    bool canCancel = true; // false: cancel() and replacing leave it alone
    bool isQueued = false; // waits for those of the same key instead of replacing them
};

/// How far a job is.
struct JobState
{
    JobId id = 0;
    JobSpec spec;
    double fraction = 0.0;               // 0..1
    QString text;                        // the stage in words
    std::optional<int> remainingSeconds; // unknown at first
    bool isCancelling = false;
    bool isWaiting = false; // for the job it replaces to stop
};

class JobRunner : public QObject
{
    Q_OBJECT
public:
    explicit JobRunner(QObject *parent = nullptr);
    /// Cancels everything and waits for it; no finish function is called any more.
    ~JobRunner() override;

    template <typename T>
    JobId start(const JobSpec &spec, std::function<Result<T>(const JobControl &)> work,
                std::function<void(Result<T>)> finish)
    {
        auto result = std::make_shared<std::optional<Result<T>>>();
        auto run = [work = std::move(work), result](const JobControl &control) {
            result->emplace(work(control));
        };
        auto done = [finish = std::move(finish), result](std::optional<Error> failure) {
            if (!finish)
                return;
            if (failure)
                finish(Result<T>(std::move(*failure)));
            else
                finish(std::move(**result));
        };
        return startErased(spec, std::move(run), std::move(done));
    }

    /// As above; \a finish is dropped if \a receiver is gone by then. For whoever may go before the runner.
    template <typename T>
    JobId start(const JobSpec &spec, QObject *receiver, std::function<Result<T>(const JobControl &)> work,
                std::function<void(Result<T>)> finish)
    {
        return start<T>(spec, std::move(work),
                        [guard = QPointer(receiver), finish = std::move(finish)](Result<T> result) {
                            if (guard && finish)
                                finish(std::move(result));
                        });
    }

    /// Asks the job to stop; its finish follows with a Cancelled error. Unknown ids, and jobs that cannot be
    /// cancelled, are left alone.
    void cancel(JobId id);
    void cancelKey(const QString &key);
    void cancelAll();

    /// Running and waiting jobs, oldest first.
    QList<JobState> jobs() const;
    /// One of them; nothing once it has finished.
    std::optional<JobState> job(JobId id) const;
    /// True while there are jobs that are not quiet.
    bool isBusy() const;

    /// Runs the event loop until no job is left. For tests and for closing; false after \a timeoutMs.
    bool waitForAll(int timeoutMs);

signals:
    void jobStarted(int id);
    /// At most 30 times a second and job.
    void jobProgress(const ductus::JobState &state);
    /// After the finish function.
    void jobFinished(int id);

private:
    struct Job;
    using Work = std::function<void(const JobControl &)>;
    using Done = std::function<void(std::optional<Error>)>;

    JobId startErased(const JobSpec &spec, Work work, Done done);
    void launch(const std::shared_ptr<Job> &job);
    void finishJob(JobId id);
    void reportProgress();
    std::shared_ptr<Job> find(JobId id) const;

    std::vector<std::shared_ptr<Job>> mJobs;
    QTimer mReportTimer;
    JobId mLastId = 0;
};

} // namespace ductus
