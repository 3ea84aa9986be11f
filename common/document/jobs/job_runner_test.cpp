#include "document/jobs/job_runner.h"

#include "document/jobs/remaining_time.h"

#include <QSignalSpy>
#include <QThread>
#include <QtTest>

using namespace ductus;

namespace {

// Runs until cancelled, at most ten seconds.
Result<int> untilCancelled(const JobControl &control)
{
    for (int i = 0; i < 2000; ++i) {
        if (control.isCancelled())
            return cancelledError("Waiting");
        QThread::msleep(5);
    }
    return 1;
}

} // namespace

class JobRunnerTest : public QObject
{
    Q_OBJECT
private slots:
    void resultsArriveOnTheCallersThread();
    void errorsArrive();
    void moveOnlyResultsArrive();
    void cancelEndsAJob();
    void aResultAfterCancellingIsDropped();
    void theSameKeyReplaces();
    void onlyTheLastOfManyRuns();
    void queuedJobsKeepTheirOrder();
    void whatCannotBeCancelledIsNot();
    void progressIsThrottledAndInOrder();
    void exceptionsBecomeErrors();
    void theDestructorCancelsAndWaits();
    void aFinishGoesWithItsReceiver();
    void quietJobsAreNotBusy();
    void aFinishMayStartTheNext();
    void remainingTimeIsSteady();
    void remainingTimeFollowsAStall();
};

void JobRunnerTest::resultsArriveOnTheCallersThread()
{
    JobRunner runner;
    QThread *worker = nullptr;
    QThread *caller = nullptr;
    int value = 0;
    const JobId id = runner.start<int>(
        {"a", "Counting"},
        [&](const JobControl &) -> Result<int> {
            worker = QThread::currentThread();
            return 42;
        },
        [&](Result<int> result) {
            caller = QThread::currentThread();
            value = *result;
        });
    QVERIFY(runner.job(id).has_value());
    QCOMPARE(runner.job(id)->spec.title, QString("Counting"));
    QVERIFY(runner.waitForAll(5000));
    QCOMPARE(value, 42);
    QVERIFY(worker != QThread::currentThread());
    QVERIFY(caller == QThread::currentThread());
    QVERIFY(!runner.job(id).has_value());
}

void JobRunnerTest::errorsArrive()
{
    JobRunner runner;
    std::string problem;
    runner.start<void>(
        {{}, "Failing"},
        [](const JobControl &) -> Result<void> {
            return Error{ErrorCode::Malformed, "Failing", "it is meant to", "", ""};
        },
        [&](Result<void> result) { problem = result.error().problem; });
    QVERIFY(runner.waitForAll(5000));
    QCOMPARE(problem, std::string("it is meant to"));
}

void JobRunnerTest::moveOnlyResultsArrive()
{
    JobRunner runner;
    int value = 0;
    runner.start<std::unique_ptr<int>>(
        {{}, "Moving"},
        [](const JobControl &) -> Result<std::unique_ptr<int>> { return std::make_unique<int>(7); },
        [&](Result<std::unique_ptr<int>> result) { value = **result; });
    QVERIFY(runner.waitForAll(5000));
    QCOMPARE(value, 7);
}

void JobRunnerTest::cancelEndsAJob()
{
    JobRunner runner;
    bool isCancelled = false;
    QElapsedTimer clock;
    clock.start();
    const JobId id = runner.start<int>({"a", "Waiting"}, untilCancelled,
                                       [&](Result<int> r) { isCancelled = !r && r.error().isCancelled(); });
    QTest::qWait(50);
    runner.cancel(id);
    QVERIFY(runner.job(id)->isCancelling);
    QVERIFY(runner.waitForAll(5000));
    QVERIFY(isCancelled);
    QVERIFY(clock.elapsed() < 3000);
    runner.cancel(id); // long gone
    runner.cancel(999);
}

void JobRunnerTest::aResultAfterCancellingIsDropped()
{
    JobRunner runner;
    bool isCancelled = false;
    const JobId id = runner.start<int>(
        {"a", "Deaf"},
        [](const JobControl &) -> Result<int> {
            QThread::msleep(100);
            return 1;
        },
        [&](Result<int> r) { isCancelled = !r && r.error().isCancelled(); });
    runner.cancel(id);
    QVERIFY(runner.waitForAll(5000));
    QVERIFY(isCancelled);
}

void JobRunnerTest::theSameKeyReplaces()
{
    JobRunner runner;
    QStringList finished;
    std::atomic<int> running = 0;
    std::atomic<bool> overlapped = false;
    runner.start<int>(
        {"surface", "First"},
        [&](const JobControl &control) {
            ++running;
            Result<int> r = untilCancelled(control);
            QThread::msleep(50);
            --running;
            return r;
        },
        [&](Result<int> r) { finished << (r ? "first" : "first cancelled"); });
    QTest::qWait(50);
    runner.start<int>(
        {"surface", "Second"},
        [&](const JobControl &) -> Result<int> {
            overlapped = running > 0;
            return 2;
        },
        [&](Result<int> r) { finished << (r ? "second" : "second cancelled"); });
    runner.start<int>(
        {"other", "Third"}, [](const JobControl &) -> Result<int> { return 3; }, [](Result<int>) {});
    QVERIFY(runner.waitForAll(10000));
    QCOMPARE(finished, (QStringList{"first cancelled", "second"}));
    QVERIFY(!overlapped);
}

void JobRunnerTest::onlyTheLastOfManyRuns()
{
    JobRunner runner;
    std::atomic<int> started = 0;
    int succeeded = -1;
    int finishes = 0;
    for (int i = 0; i < 50; ++i) {
        runner.start<int>(
            {"drag", "Dragging"},
            [&started, i](const JobControl &control) -> Result<int> {
                ++started;
                for (int k = 0; k < 20 && !control.isCancelled(); ++k)
                    QThread::msleep(2);
                return i;
            },
            [&](Result<int> r) {
                ++finishes;
                if (r)
                    succeeded = *r;
            });
    }
    QVERIFY(runner.waitForAll(10000));
    QCOMPARE(finishes, 50);
    QCOMPARE(succeeded, 49);
    QVERIFY2(started <= 3, qPrintable(QString::number(started)));
}

void JobRunnerTest::queuedJobsKeepTheirOrder()
{
    JobRunner runner;
    QList<int> order;
    for (int i = 0; i < 4; ++i) {
        JobSpec spec{"save", "Saving"};
        spec.isQueued = true;
        runner.start<int>(
            spec,
            [i](const JobControl &) -> Result<int> {
                QThread::msleep(std::size_t(40 - 10 * i));
                return i;
            },
            [&](Result<int> r) { order << *r; });
    }
    QVERIFY(runner.waitForAll(10000));
    QCOMPARE(order, (QList<int>{0, 1, 2, 3}));
}

void JobRunnerTest::whatCannotBeCancelledIsNot()
{
    JobRunner runner;
    bool isDone = false;
    JobSpec spec{"save", "Saving"};
    spec.canCancel = false;
    runner.start<int>(
        spec,
        [](const JobControl &) -> Result<int> {
            QThread::msleep(50);
            return 1;
        },
        [&](Result<int> r) { isDone = r.ok(); });
    runner.cancelAll();
    QVERIFY(runner.waitForAll(5000));
    QVERIFY(isDone);
}

void JobRunnerTest::progressIsThrottledAndInOrder()
{
    JobRunner runner;
    QList<double> fractions;
    QString text;
    connect(&runner, &JobRunner::jobProgress, this, [&](const JobState &state) {
        fractions << state.fraction;
        text = state.text;
    });
    QElapsedTimer clock;
    clock.start();
    runner.start<int>(
        {{}, "Counting"},
        [](const JobControl &control) -> Result<int> {
            for (int i = 0; i < 500; ++i) {
                control.progress(i / 500.0, "Fitting \xc3\xa9"); // UTF-8
                QThread::usleep(1000);
            }
            return 1;
        },
        [](Result<int>) {});
    QVERIFY(runner.waitForAll(20000));
    const double seconds = double(clock.elapsed()) / 1000.0;
    QVERIFY(fractions.size() >= 3);
    QVERIFY2(double(fractions.size()) <= 30.0 * seconds + 1.0, qPrintable(QString::number(fractions.size())));
    QVERIFY(std::is_sorted(fractions.begin(), fractions.end()));
    QCOMPARE(text, QString::fromUtf8("Fitting \xc3\xa9"));
}

void JobRunnerTest::exceptionsBecomeErrors()
{
    JobRunner runner;
    std::string message;
    runner.start<int>(
        {{}, "Throwing"}, [](const JobControl &) -> Result<int> { throw std::runtime_error("oops"); },
        [&](Result<int> r) { message = r.error().message(); });
    QVERIFY(runner.waitForAll(5000));
    QVERIFY(QString::fromStdString(message).contains("oops"));
}

void JobRunnerTest::theDestructorCancelsAndWaits()
{
    std::atomic<bool> ended = false;
    bool isTold = false;
    {
        JobRunner runner;
        runner.start<int>(
            {{}, "Waiting"},
            [&](const JobControl &control) {
                Result<int> r = untilCancelled(control);
                ended = true;
                return r;
            },
            [&](Result<int>) { isTold = true; });
        QTest::qWait(30);
    }
    QVERIFY(ended);
    QTest::qWait(30);
    QVERIFY(!isTold);
}

void JobRunnerTest::aFinishGoesWithItsReceiver()
{
    JobRunner runner;
    auto leaving = std::make_unique<QObject>();
    QObject staying;
    int called = 0;
    for (QObject *receiver : {leaving.get(), &staying})
        runner.start<int>({}, receiver, untilCancelled, [&called](Result<int> result) {
            QVERIFY(!result.ok());
            ++called;
        });
    leaving.reset();
    runner.cancelAll();
    QVERIFY(runner.waitForAll(5000));
    QCOMPARE(called, 1);
}

void JobRunnerTest::quietJobsAreNotBusy()
{
    JobRunner runner;
    JobSpec quiet{{}, "Autosaving"};
    quiet.isQuiet = true;
    runner.start<int>(
        quiet, [](const JobControl &) -> Result<int> { return 1; }, [](Result<int>) {});
    QVERIFY(!runner.isBusy());
    runner.start<int>(
        {{}, "Loud"}, [](const JobControl &) -> Result<int> { return 1; }, [](Result<int>) {});
    QVERIFY(runner.isBusy());
    QVERIFY(runner.waitForAll(5000));
    QVERIFY(!runner.isBusy());
}

void JobRunnerTest::aFinishMayStartTheNext()
{
    JobRunner runner;
    int done = 0;
    std::function<void(Result<int>)> again = [&](Result<int> r) {
        QVERIFY(r.ok());
        if (++done < 5)
            runner.start<int>(
                {"chain", "Chain"}, [](const JobControl &) -> Result<int> { return 1; }, again);
    };
    runner.start<int>(
        {"chain", "Chain"}, [](const JobControl &) -> Result<int> { return 1; }, again);
    QVERIFY(runner.waitForAll(10000));
    QCOMPARE(done, 5);
}

void JobRunnerTest::remainingTimeIsSteady()
{
    RemainingTime remaining;
    QVERIFY(!remaining.estimate(0.5));
    for (int i = 1; i <= 60; ++i)
        remaining.note(i, i / 120.0); // two minutes in all
    QVERIFY(remaining.estimate(60.0));
    QVERIFY(std::abs(*remaining.estimate(60.0) - 60) <= 2);
    QVERIFY(std::abs(*remaining.estimate(63.0) - 57) <= 2);
}

void JobRunnerTest::remainingTimeFollowsAStall()
{
    RemainingTime remaining;
    for (int i = 1; i <= 10; ++i)
        remaining.note(i, i / 20.0);
    // Ten seconds should be left; after a minute of silence nobody knows.
    QVERIFY(!remaining.estimate(70.0));
    remaining.note(71.0, 0.55);
    QVERIFY(remaining.estimate(71.0));
    QVERIFY(*remaining.estimate(71.0) > 15);
}

QTEST_GUILESS_MAIN(JobRunnerTest)
#include "job_runner_test.moc"
