#include "document/jobs/job_runner.h"

#include "base/background_work.h"
#include "document/jobs/remaining_time.h"
#include "document/words/engine_words.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QThread>
#include <algorithm>
#include <mutex>
#include <string>

namespace ductus {

namespace {

constexpr int reportIntervalMs = 34; // just under 30 a second

} // namespace

struct JobRunner::Job
{
    JobId id = 0;
    JobSpec spec;
    Work work;
    Done done;
    std::atomic<bool> cancelFlag = false;
    std::unique_ptr<QThread> thread; // null while waiting
    JobId waitsFor = 0;
    std::optional<Error> crash; // an exception that came out of the work
    QElapsedTimer clock;
    RemainingTime remaining;

    // Written by workers, read by the timer.
    std::mutex mutex;
    double fraction = 0.0;
    std::string text;
    bool hasNews = false;

    void note(double newFraction, std::string_view newText)
    {
        const std::lock_guard guard(mutex);
        // Parallel stages report out of order; a bar that jumps back is worse than one that waits.
        fraction = std::max(fraction, newFraction);
        if (!newText.empty())
            text = newText;
        hasNews = true;
    }

    JobState state()
    {
        JobState result;
        result.id = id;
        result.spec = spec;
        result.isCancelling = cancelFlag.load();
        result.isWaiting = !thread;
        const std::lock_guard guard(mutex);
        result.fraction = fraction;
        result.text = engineWords(text);
        if (thread)
            result.remainingSeconds = remaining.estimate(double(clock.elapsed()) / 1000.0);
        return result;
    }
};

JobRunner::JobRunner(QObject *parent) : QObject(parent)
{
    mReportTimer.setInterval(reportIntervalMs);
    connect(&mReportTimer, &QTimer::timeout, this, &JobRunner::reportProgress);
}

JobRunner::~JobRunner()
{
    for (const std::shared_ptr<Job> &job : mJobs)
        job->cancelFlag = true;
    for (const std::shared_ptr<Job> &job : mJobs) {
        if (job->thread)
            job->thread->wait();
    }
}

JobId JobRunner::startErased(const JobSpec &spec, Work work, Done done)
{
    auto job = std::make_shared<Job>();
    job->id = ++mLastId;
    job->spec = spec;
    job->work = std::move(work);
    job->done = std::move(done);
    if (!spec.key.isEmpty()) {
        // The chain of one key has at most one running and one waiting job that is not cancelled. Waiting
        // keeps a slider that is dragged from starting a hundred threads.
        for (const std::shared_ptr<Job> &other : std::vector(mJobs)) {
            if (other->spec.key == spec.key) {
                if (!spec.isQueued)
                    cancel(other->id);
                job->waitsFor = other->id;
            }
        }
    }
    mJobs.push_back(job);
    if (!find(job->waitsFor))
        launch(job);
    if (!mReportTimer.isActive())
        mReportTimer.start();
    emit jobStarted(job->id);
    return job->id;
}

void JobRunner::launch(const std::shared_ptr<Job> &job)
{
    job->waitsFor = 0;
    job->clock.start();
    job->thread.reset(QThread::create([job = job.get()] {
        const BackgroundWork background;
        const auto report = [job](double fraction, std::string_view text) { job->note(fraction, text); };
        // Exceptions are bugs, but one in a job must not take the user's unsaved document with it.
        try {
            job->work(JobControl(&job->cancelFlag, report));
        } catch (const std::bad_alloc &) {
            job->crash = Error{ErrorCode::TooLarge, job->spec.title.toStdString(), "the memory ran out",
                               "Close other programs or work on a smaller part", ""};
        } catch (const std::exception &exception) {
            job->crash = Error{ErrorCode::NoSolution, job->spec.title.toStdString(),
                               std::string("an internal error occurred (") + exception.what() + ")",
                               "Save your work and report this with the file", ""};
        }
    }));
    const JobId id = job->id;
    connect(job->thread.get(), &QThread::finished, this, [this, id] { finishJob(id); });
    job->thread->start();
}

void JobRunner::finishJob(JobId id)
{
    const std::shared_ptr<Job> job = find(id);
    if (!job)
        return;
    if (job->thread)
        job->thread->wait();
    mJobs.erase(std::find(mJobs.begin(), mJobs.end(), job));
    // The next of the chain starts before the finish function can start another one of the same key.
    for (const std::shared_ptr<Job> &waiting : std::vector(mJobs)) {
        if (waiting->waitsFor == id) {
            if (waiting->cancelFlag)
                QMetaObject::invokeMethod(
                    this, [this, next = waiting->id] { finishJob(next); }, Qt::QueuedConnection);
            else
                launch(waiting);
        }
    }
    std::optional<Error> failure = std::move(job->crash);
    if (job->cancelFlag)
        failure = cancelledError(job->spec.title.toStdString());
    job->work = nullptr;
    job->done(std::move(failure));
    if (mJobs.empty())
        mReportTimer.stop();
    emit jobFinished(id);
}

void JobRunner::cancel(JobId id)
{
    const std::shared_ptr<Job> job = find(id);
    if (!job || !job->spec.canCancel || job->cancelFlag.exchange(true))
        return;
    {
        const std::lock_guard guard(job->mutex);
        job->hasNews = true;
    }
    if (!job->thread && job->waitsFor == 0)
        finishJob(id);
}

void JobRunner::cancelKey(const QString &key)
{
    for (const std::shared_ptr<Job> &job : std::vector(mJobs)) {
        if (job->spec.key == key)
            cancel(job->id);
    }
}

void JobRunner::cancelAll()
{
    for (const std::shared_ptr<Job> &job : std::vector(mJobs))
        cancel(job->id);
}

QList<JobState> JobRunner::jobs() const
{
    QList<JobState> states;
    for (const std::shared_ptr<Job> &job : mJobs)
        states.append(job->state());
    return states;
}

std::optional<JobState> JobRunner::job(JobId id) const
{
    if (const std::shared_ptr<Job> job = find(id))
        return job->state();
    return std::nullopt;
}

bool JobRunner::isBusy() const
{
    return std::any_of(mJobs.begin(), mJobs.end(), [](const auto &job) { return !job->spec.isQuiet; });
}

bool JobRunner::waitForAll(int timeoutMs)
{
    QElapsedTimer clock;
    clock.start();
    while (!mJobs.empty()) {
        if (clock.elapsed() > timeoutMs)
            return false;
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
    }
    return true;
}

void JobRunner::reportProgress()
{
    for (const std::shared_ptr<Job> &job : std::vector(mJobs)) {
        {
            const std::lock_guard guard(job->mutex);
            if (!job->hasNews)
                continue;
            job->hasNews = false;
            if (job->thread)
                job->remaining.note(double(job->clock.elapsed()) / 1000.0, job->fraction);
        }
        emit jobProgress(job->state());
    }
}

std::shared_ptr<JobRunner::Job> JobRunner::find(JobId id) const
{
    const auto hasId = [&](const std::shared_ptr<Job> &job) { return job->id == id; };
    const auto found = std::find_if(mJobs.begin(), mJobs.end(), hasId);
    return found == mJobs.end() ? nullptr : *found;
}

} // namespace ductus
