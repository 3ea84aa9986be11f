#include "cli/terminal_job.h"

#include "cli/exit_code.h"

#include <QTemporaryFile>
#include <QtTest>

#include <csignal>
#include <cstdio>
#include <unistd.h>

using namespace ductus;

class TerminalJobTest : public QObject
{
    Q_OBJECT
private slots:
    void firstSignalCancels_data();
    void firstSignalCancels();
    void handlersAreGivenBack();
    void ignoredSignalStaysIgnored();
    void progressIsOneLineAStepAndNeverRunsBackwards();
    void quietShowsNothing();
    void exitCodes();
};

namespace {

/// What \a action writes to stderr.
QByteArray stderrOf(const std::function<void()> &action)
{
    QTemporaryFile file;
    if (!file.open())
        return "no temporary file";
    std::fflush(stderr);
    const int kept = ::dup(STDERR_FILENO);
    ::dup2(file.handle(), STDERR_FILENO);
    action();
    std::fflush(stderr);
    ::dup2(kept, STDERR_FILENO);
    ::close(kept);
    file.seek(0);
    return file.readAll();
}

} // namespace

void TerminalJobTest::firstSignalCancels_data()
{
    QTest::addColumn<int>("signal");
    QTest::newRow("Ctrl-C") << SIGINT;
    QTest::newRow("kill") << SIGTERM;
    QTest::newRow("closed terminal") << SIGHUP;
}

void TerminalJobTest::firstSignalCancels()
{
    QFETCH(int, signal);
    TerminalJob job(true);
    const JobControl control = job.control();
    QVERIFY2(!control.isCancelled(), "the cancel of the job before is forgotten");
    std::raise(signal);
    QVERIFY(control.isCancelled());
    QVERIFY(control.part(0.2, 0.4).isCancelled());
}

void TerminalJobTest::handlersAreGivenBack()
{
    const auto mine = [](int) {};
    const auto before = std::signal(SIGINT, mine);
    {
        TerminalJob job(true);
    }
    QVERIFY(std::signal(SIGINT, before) == static_cast<void (*)(int)>(mine));
}

void TerminalJobTest::ignoredSignalStaysIgnored()
{
    const auto before = std::signal(SIGHUP, SIG_IGN);
    {
        TerminalJob job(true);
        std::raise(SIGHUP);
        QVERIFY2(!job.control().isCancelled(), "nohup must keep it running");
    }
    QVERIFY(std::signal(SIGHUP, before) == SIG_IGN);
}

void TerminalJobTest::progressIsOneLineAStepAndNeverRunsBackwards()
{
    const QByteArray said = stderrOf([] {
        TerminalJob job(false);
        const JobControl control = job.control();
        control.progress(0.0, "Reading");
        control.progress(0.1, "Reading");
        control.progress(0.5, "Fitting");
        control.progress(0.3, "Choosing");
        control.progress(1.0, "Done");
    });
    QCOMPARE(said, QByteArray("  0 %  Reading\n 50 %  Fitting\n 50 %  Choosing\n100 %  Done\n"));
}

void TerminalJobTest::quietShowsNothing()
{
    QCOMPARE(stderrOf([] {
                 TerminalJob job(true);
                 job.control().progress(0.5, "Fitting");
                 job.finishLine();
             }),
             QByteArray());
}

void TerminalJobTest::exitCodes()
{
    QCOMPARE(int(ExitCode::Done), 0);
    QCOMPARE(int(ExitCode::WrongUsage), 2);
    QCOMPARE(int(exitCodeFor(cancelledError("Fitting"))), 3);
    QCOMPARE(int(exitCodeFor(Error{})), 1);
}

QTEST_APPLESS_MAIN(TerminalJobTest)
#include "terminal_job_test.moc"
