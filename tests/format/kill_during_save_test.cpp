// "The power went off while I saved": a program that saves again and again is killed at random moments, and
// what stands on the disk must each time be exactly one of the two projects it was saving.
#include "kill_states.h"
#include "project/project_reader.h"
#include "project/saving/project_lock.h"
#include "project/saving/project_save.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest>

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

using namespace ductus;
namespace fs = std::filesystem;

namespace {

struct Child
{
    pid_t pid = -1;
    int output = -1;
};

Child startLoop(const fs::path &path)
{
    int pipe[2];
    if (::pipe2(pipe, O_CLOEXEC) != 0)
        return {};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
    std::string program = DUCTUS_SAVE_LOOP;
    std::string argument = path.string();
    char *arguments[] = {program.data(), argument.data(), nullptr};
    Child child;
    if (::posix_spawn(&child.pid, program.c_str(), &actions, nullptr, arguments, environ) != 0)
        child.pid = -1;
    posix_spawn_file_actions_destroy(&actions);
    ::close(pipe[1]);
    child.output = pipe[0];
    return child;
}

int stateOf(const fs::path &path, const Project (&states)[2])
{
    const Result<Project> read = openProject(path);
    if (!read)
        qWarning("%s", read.error().message().c_str());
    for (int state = 0; read.ok() && state < 2; ++state) {
        if (difference(states[state], *read).empty())
            return state;
    }
    return -1;
}

int leftovers(const fs::path &folder)
{
    int count = 0;
    for (const fs::directory_entry &file : fs::directory_iterator(folder))
        count += file.path().extension() == ".tmp";
    return count;
}

} // namespace

class KillDuringSaveTest : public QObject
{
    Q_OBJECT
private slots:
    void killAtAnyInstantLosesNothing();
};

void KillDuringSaveTest::killAtAnyInstantLosesNothing()
{
    QTemporaryDir folder;
    QVERIFY(folder.isValid());
    const fs::path path = fs::path(folder.path().toStdString()) / "killed.ductus";
    const Project states[2] = {killState(0), killState(1)};
    QElapsedTimer timer;
    timer.start();
    QVERIFY(saveProject(states[0], path).ok());
    for (int i = 1; i < 10; ++i)
        QVERIFY(saveProject(states[i % 2], path).ok());
    const double saveSeconds = double(timer.nsecsElapsed()) / 1e10;

    Random random(20260214);
    constexpr int kills = 200;
    int killsWithLeftovers = 0;
    int seen[2] = {0, 0};
    for (int kill = 0; kill < kills; ++kill) {
        const Child child = startLoop(path);
        QVERIFY(child.pid > 0);
        char byte = 0;
        const bool started = ::read(child.output, &byte, 1) == 1;
        // Up to three saves long, so that the kill meets every step of a save.
        const double delay = random.uniform() * 3.0 * saveSeconds;
        ::usleep(useconds_t(delay * 1e6));
        const bool alive = ::waitpid(child.pid, nullptr, WNOHANG) == 0;
        if (alive) {
            ::kill(child.pid, SIGKILL);
            ::waitpid(child.pid, nullptr, 0);
        }
        ::close(child.output);
        QVERIFY2(started && alive, "the saving program ended by itself");

        const int state = stateOf(path, states);
        QVERIFY2(state >= 0, qPrintable(QString("after kill %1").arg(kill)));
        ++seen[state];
        QVERIFY(stateOf(previousVersionPath(path), states) >= 0);
        QVERIFY(leftovers(path.parent_path()) <= 2);
        killsWithLeftovers += leftovers(path.parent_path()) > 0;
        QVERIFY(fs::exists(lockPath(path))); // the next start must not be stopped by it
    }
    qInfo("%d kills, %d of them left a temporary file, states found: %d even, %d odd, %.1f ms a save", kills,
          killsWithLeftovers, seen[0], seen[1], saveSeconds * 1e3);
    QVERIFY2(killsWithLeftovers >= kills / 20, "too few kills met a save half way: the test proves nothing");
    QVERIFY(seen[0] > 0 && seen[1] > 0);
    QVERIFY(saveProject(states[0], path).ok());
    QCOMPARE(leftovers(path.parent_path()), 0);
}

QTEST_APPLESS_MAIN(KillDuringSaveTest)
#include "kill_during_save_test.moc"
