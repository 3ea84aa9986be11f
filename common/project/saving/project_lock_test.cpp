#include "project/saving/project_lock.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

using namespace ductus;

namespace {

void writeText(const std::filesystem::path &path, const std::string &text)
{
    std::ofstream(path) << text;
}

// A child that takes the lock, tells so, and waits to be killed.
pid_t childWithLock(const std::filesystem::path &path)
{
    int pipe[2];
    if (::pipe2(pipe, O_CLOEXEC) != 0)
        return -1;
    const pid_t child = ::fork();
    if (child == 0) {
        const Result<ProjectLock> lock = ProjectLock::acquire(path, "Other");
        const char answer = lock.ok() ? 'y' : 'n';
        static_cast<void>(!::write(pipe[1], &answer, 1));
        for (;;)
            ::pause();
    }
    char answer = 'n';
    const bool told = ::read(pipe[0], &answer, 1) == 1;
    ::close(pipe[0]);
    ::close(pipe[1]);
    return told && answer == 'y' ? child : -1;
}

} // namespace

class ProjectLockTest : public QObject
{
    Q_OBJECT
private slots:
    void init() { QVERIFY(mFolder.emplace().isValid()); }
    void lockIsTakenAndGivenBack();
    void secondIsToldWhoHasIt();
    void lockOfAKilledProgramIsTakenOver();
    void lockOfAnotherHostStaysUntilBroken();
    void staleAndTornLocksAreTakenOver();
    void ownersAreToldApart();
    void folderThatIsMissing();

private:
    std::filesystem::path project() const
    {
        return std::filesystem::path(mFolder->path().toStdString()) /
               "\xd1\x88\xd0\xbb\xd1\x8f\xd0\xbf\xd0\xb0.ductus";
    }
    std::optional<QTemporaryDir> mFolder;
};

void ProjectLockTest::lockIsTakenAndGivenBack()
{
    {
        const Result<ProjectLock> lock = ProjectLock::acquire(project(), "Test");
        QVERIFY(lock.ok());
        QVERIFY(std::filesystem::exists(lockPath(project())));
        QVERIFY(lockPath(project()).string().ends_with(".ductus.lock"));
    }
    QVERIFY(!std::filesystem::exists(lockPath(project())));
    QVERIFY(ProjectLock::acquire(project(), "Test").ok());
}

void ProjectLockTest::secondIsToldWhoHasIt()
{
    const Result<ProjectLock> first = ProjectLock::acquire(project(), "LayerPainter");
    QVERIFY(first.ok());
    const Result<ProjectLock> second = ProjectLock::acquire(project(), "SketchSurfacer");
    QCOMPARE(second.error().code, ErrorCode::Locked);
    const std::string message = second.error().message();
    QVERIFY(message.find("LayerPainter") != std::string::npos);
    QVERIFY(message.find(std::to_string(::getpid())) != std::string::npos);
    QCOMPARE(ProjectLock::breakLock(project()).error().code, ErrorCode::Locked);
}

void ProjectLockTest::lockOfAKilledProgramIsTakenOver()
{
    const pid_t child = childWithLock(project());
    QVERIFY(child > 0);
    const Result<ProjectLock> refused = ProjectLock::acquire(project(), "Test");
    const std::string message = refused.ok() ? "" : refused.error().message();
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    QVERIFY(message.find("Other") != std::string::npos);
    QVERIFY(message.find("process " + std::to_string(child)) != std::string::npos);
    QVERIFY(std::filesystem::exists(lockPath(project()))); // it was left behind
    QVERIFY(ProjectLock::acquire(project(), "Test").ok());
}

void ProjectLockTest::lockOfAnotherHostStaysUntilBroken()
{
    LockOwner owner = LockOwner::self("SketchSurfacer");
    owner.host = "elsewhere";
    writeText(lockPath(project()), owner.toText());
    const Result<ProjectLock> lock = ProjectLock::acquire(project(), "Test");
    QCOMPARE(lock.error().code, ErrorCode::Locked);
    QVERIFY(lock.error().message().find("elsewhere") != std::string::npos);
    QVERIFY(ProjectLock::breakLock(project()).ok());
    QVERIFY(ProjectLock::acquire(project(), "Test").ok());
    QVERIFY(ProjectLock::breakLock(project()).ok()); // nothing there is fine
}

void ProjectLockTest::staleAndTornLocksAreTakenOver()
{
    LockOwner gone = LockOwner::self("Gone");
    gone.startTicks += 1; // the same pid, but another process
    for (const std::string &text :
         {gone.toText(), std::string(), std::string("{\"pid\": 1"), std::string(9000, 'x')}) {
        writeText(lockPath(project()), text);
        const Result<ProjectLock> lock = ProjectLock::acquire(project(), "Test");
        QVERIFY2(lock.ok(), text.c_str());
    }
}

void ProjectLockTest::ownersAreToldApart()
{
    const LockOwner self = LockOwner::self("A \"quoted\" app");
    const Result<LockOwner> back = LockOwner::parse(self.toText());
    QVERIFY(back.ok());
    QCOMPARE(back->toText(), self.toText());
    QVERIFY(self.startTicks > 0);
    QVERIFY(self.mayBeAlive());
    LockOwner other = self;
    other.startTicks += 1;
    QVERIFY(!other.mayBeAlive());
    other = self;
    other.bootId = "another";
    QVERIFY(!other.mayBeAlive());
    other.host = "elsewhere";
    QVERIFY(other.mayBeAlive());
    QVERIFY(!LockOwner::parse("{\"pid\": -5}").ok());
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(0);
    ::waitpid(child, nullptr, 0);
    other = self;
    other.pid = child;
    QVERIFY(!other.mayBeAlive());
}

void ProjectLockTest::folderThatIsMissing()
{
    QCOMPARE(ProjectLock::acquire(project() / "no" / "x.ductus", "Test").error().code,
             ErrorCode::FileNotFound);
}

QTEST_APPLESS_MAIN(ProjectLockTest)
#include "project_lock_test.moc"
