#include "cli/output_files.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <csignal>
#include <sys/resource.h>
#include <unistd.h>

using namespace ductus;
namespace fs = std::filesystem;

class OutputFilesTest : public QObject
{
    Q_OBJECT
private slots:
    void nothingIsVisibleBeforeCommit();
    void withoutCommitNothingIsLeft();
    void failedFileTakesTheOthersWithIt();
    void failedRenameTakesBackTheNewFiles();
    void writablePlaces();
    void sameFileHoweverSpelled();

private:
    QTemporaryDir mFolder;
    fs::path path(const char *name) const { return fs::path(mFolder.path().toStdString()) / name; }
    QStringList names() const
    {
        return QDir(mFolder.path())
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    }
    QByteArray content(const char *name) const
    {
        QFile file(mFolder.filePath(QString::fromLatin1(name)));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(none)");
    }
};

namespace {

std::span<const std::byte> bytes(const std::string &text)
{
    return std::as_bytes(std::span(text));
}

} // namespace

void OutputFilesTest::nothingIsVisibleBeforeCommit()
{
    const std::string one = "one", two = "two";
    OutputFiles files;
    QVERIFY(files.add(path("a"), bytes(one), "Writing a").ok());
    QVERIFY(files.add(path("b"), bytes(two), "Writing b").ok());
    QCOMPARE(content("a"), QByteArray("(none)"));
    QVERIFY(files.commit().ok());
    QCOMPARE(content("a"), QByteArray("one"));
    QCOMPARE(content("b"), QByteArray("two"));
    QCOMPARE(names(), (QStringList{"a", "b"}));
}

void OutputFilesTest::withoutCommitNothingIsLeft()
{
    const QStringList before = names();
    const std::string text = "lost";
    {
        OutputFiles files;
        QVERIFY(files.add(path("a"), bytes(text), "Writing a").ok());
        QVERIFY(files.add(path("c"), bytes(text), "Writing c").ok());
        QVERIFY2(names() != before, "the temporaries are in the folder of the target");
    }
    QCOMPARE(names(), before);
    QCOMPARE(content("a"), QByteArray("one"));
}

void OutputFilesTest::failedFileTakesTheOthersWithIt()
{
    const QStringList before = names();
    const std::string small(100, 's'), large(100'000, 'l');
    rlimit limit = {};
    QCOMPARE(::getrlimit(RLIMIT_FSIZE, &limit), 0);
    const rlim_t largest = limit.rlim_cur;
    limit.rlim_cur = 10'000;
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    Result<void> added;
    {
        OutputFiles files;
        QVERIFY(files.add(path("small"), bytes(small), "Writing the report").ok());
        added = files.add(path("large"), bytes(large), "Writing the mesh");
    }
    limit.rlim_cur = largest;
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    std::signal(SIGXFSZ, handler);
    QVERIFY(!added.ok());
    QCOMPARE(QString::fromStdString(added.error().place), QString::fromStdString(path("large").string()));
    QCOMPARE(QString::fromStdString(added.error().attempted), QString("Writing the mesh"));
    QCOMPARE(names(), before);
}

void OutputFilesTest::failedRenameTakesBackTheNewFiles()
{
    const QStringList before = names();
    const std::string text = "text";
    OutputFiles files;
    QVERIFY(files.add(path("first"), bytes(text), "Writing the report").ok());
    QVERIFY(files.add(path("second"), bytes(text), "Writing the mesh").ok());
    QVERIFY(QDir(mFolder.path()).mkpath("second/full")); // somebody else made a folder of that name meanwhile
    const Result<void> committed = files.commit();
    QVERIFY(!committed.ok());
    QCOMPARE(QString::fromStdString(committed.error().place),
             QString::fromStdString(path("second").string()));
    QVERIFY(QDir(mFolder.filePath("second")).removeRecursively());
    QCOMPARE(names(), before);
}

void OutputFilesTest::writablePlaces()
{
    QVERIFY(checkWritable(path("new"), "Writing").ok());
    QVERIFY(checkWritable(path("a"), "Writing").ok());
    QVERIFY(checkWritable("new-in-the-current-folder", "Writing").ok());
    QCOMPARE(int(checkWritable(path("none/new"), "Writing").error().code), int(ErrorCode::FileNotFound));
    QCOMPARE(int(checkWritable(path("a/new"), "Writing").error().code), int(ErrorCode::FileNotFound));
    QCOMPARE(int(checkWritable(mFolder.path().toStdString(), "Writing").error().code),
             int(ErrorCode::NotAFile));
    QCOMPARE(int(checkWritable(path("new/"), "Writing").error().code), int(ErrorCode::NotAFile));
    QCOMPARE(int(checkWritable("/dev/null", "Writing").error().code), int(ErrorCode::NotAFile));
    QVERIFY(QFile::link(mFolder.filePath("none/new"), mFolder.filePath("dangling")));
    QCOMPARE(int(checkWritable(path("dangling"), "Writing").error().code), int(ErrorCode::FileNotFound));
    QVERIFY(QFile::remove(mFolder.filePath("dangling")));
}

void OutputFilesTest::sameFileHoweverSpelled()
{
    QVERIFY(isSameFile(path("a"), path("./a")));
    QVERIFY(isSameFile(path("new"), path("./new")));
    QVERIFY(isSameFile(path("new"), path("none/../new")));
    QVERIFY(!isSameFile(path("a"), path("b")));
    QVERIFY(!isSameFile(path("a"), path("new")));
    QVERIFY(isSameFile("new", fs::current_path() / "new"));
    QVERIFY(QFile::link(mFolder.filePath("new"), mFolder.filePath("link")));
    QVERIFY2(isSameFile(path("link"), path("new")), "a link to a file that is not there yet");
    QVERIFY(QFile::remove(mFolder.filePath("link")));
}

QTEST_APPLESS_MAIN(OutputFilesTest)
#include "output_files_test.moc"
