#include "project/saving/project_save.h"

#include "project/container/container_reader.h"
#include "project/container/entry_name.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "project/saving/temporary_file.h"
#include "project/testing/sample_project.h"

#include <QTemporaryDir>
#include <QtTest>

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <functional>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

int fileCount(const fs::path &folder)
{
    return int(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// Runs \a body in a child, because limits and user ids belong to the whole process. True if it returned true.
bool inChild(const std::function<bool()> &body)
{
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(body() ? 0 : 1);
    int status = 1;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace

class ProjectSaveTest : public QObject
{
    Q_OBJECT
private slots:
    void init() { QVERIFY(mFolder.emplace().isValid()); }
    void savedProjectOpens();
    void previousVersionIsKept();
    void unchangedBuffersAreCopied();
    void nonLatinAndLongNames();
    void linksStayLinks();
    void permissionsAreKept();
    void fullDiskLeavesTheOldFile();
    void unwritableFolderLeavesTheOldFile();
    void readOnlyFileIsNotReplaced();
    void missingFolderAndFolderAsTarget();
    void leftoversOfKilledSavesAreRemoved();
    void damageElsewhereDoesNotStopASave();
    void previousThatCannotBeKeptIsOnlyAWarning();

private:
    fs::path folder() const { return mFolder->path().toStdString(); }
    std::optional<QTemporaryDir> mFolder;
};

void ProjectSaveTest::savedProjectOpens()
{
    const fs::path path = folder() / "a.ductus";
    const Project project = sampleProject(1);
    const Result<SaveReport> report = saveProject(project, path);
    QVERIFY2(report.ok(), report.ok() ? "" : report.error().message().c_str());
    QCOMPARE(report->bytes, std::uint64_t(fs::file_size(path)));
    QVERIFY(report->warnings.empty());
    QCOMPARE(difference(project, *openProject(path)), std::string());
    QCOMPARE(fileCount(folder()), 1);
    QCOMPARE(openProject(folder() / "none.ductus").error().code, ErrorCode::FileNotFound);
}

void ProjectSaveTest::previousVersionIsKept()
{
    const fs::path path = folder() / "a.ductus";
    for (int i = 1; i <= 3; ++i)
        QVERIFY(saveProject(sampleProject(std::uint64_t(i)), path).ok());
    QCOMPARE(difference(sampleProject(3), *openProject(path)), std::string());
    QCOMPARE(difference(sampleProject(2), *openProject(previousVersionPath(path))), std::string());
    QCOMPARE(fileCount(folder()), 2);
    // As after a kill between keeping the previous version and the last rename: both names, one file.
    fs::remove(previousVersionPath(path));
    fs::create_hard_link(path, previousVersionPath(path));
    QVERIFY(saveProject(sampleProject(4), path).ok());
    QCOMPARE(difference(sampleProject(3), *openProject(previousVersionPath(path))), std::string());
    QCOMPARE(fileCount(folder()), 2);
}

void ProjectSaveTest::unchangedBuffersAreCopied()
{
    const fs::path path = folder() / "a.ductus";
    Project project = sampleProject(1);
    Result<SaveReport> report = saveProject(project, path);
    const int all = report->packedBuffers;
    project.buffers = report->buffers;
    auto changed = std::make_shared<SketchSurfaceDocument>(*project.documents[1].sketchSurface);
    changed->strokes.strokes[0].points[0].x() += 1e-9;
    project.documents[1].sketchSurface = changed;
    report = saveProject(project, path);
    QCOMPARE(report->packedBuffers, 1);
    QCOMPARE(report->copiedBuffers, all - 1);
}

void ProjectSaveTest::nonLatinAndLongNames()
{
    const std::string scripts[] = {"\xe5\xb8\xbd\xe5\xad\x90.ductus", "\xd8\xb1\xd8\xb3\xd9\x85.ductus",
                                   "a b'\"$\n.ductus", std::string(240, 'x') + ".ductus"};
    for (const std::string &name : scripts) {
        const fs::path path = folder() / "\xd0\xbf\xd0\xb0\xd0\xbf\xd0\xba\xd0\xb0" / name;
        fs::create_directories(path.parent_path());
        QVERIFY(saveProject(sampleProject(1), path).ok());
        QVERIFY(saveProject(sampleProject(2), path).ok());
        QCOMPARE(difference(sampleProject(2), *openProject(path)), std::string());
        QCOMPARE(difference(sampleProject(1), *openProject(previousVersionPath(path))), std::string());
    }
}

void ProjectSaveTest::linksStayLinks()
{
    fs::create_directories(folder() / "real");
    const fs::path real = folder() / "real" / "r.ductus";
    const fs::path link = folder() / "link.ductus";
    QVERIFY(saveProject(sampleProject(1), real).ok());
    fs::create_symlink(real, link);
    QVERIFY(saveProject(sampleProject(2), link).ok());
    QVERIFY(fs::is_symlink(link));
    QCOMPARE(difference(sampleProject(2), *openProject(real)), std::string());
    QVERIFY(fs::exists(previousVersionPath(real)));
}

void ProjectSaveTest::permissionsAreKept()
{
    const fs::path path = folder() / "a.ductus";
    QVERIFY(saveProject(sampleProject(1), path).ok());
    QVERIFY(::chmod(path.c_str(), 0640) == 0);
    QVERIFY(saveProject(sampleProject(2), path).ok());
    QCOMPARE(int(fs::status(path).permissions()), 0640);
}

void ProjectSaveTest::fullDiskLeavesTheOldFile()
{
    const fs::path path = folder() / "a.ductus";
    QVERIFY(saveProject(sampleProject(1), path).ok());
    QVERIFY(inChild([&] {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit = {1000, 1000}; // no file may grow beyond, as on a full disk
        ::setrlimit(RLIMIT_FSIZE, &limit);
        const Result<SaveReport> report = saveProject(sampleProject(2), path);
        return !report.ok() && report.error().code == ErrorCode::WriteFailed;
    }));
    QCOMPARE(difference(sampleProject(1), *openProject(path)), std::string());
    QCOMPARE(fileCount(folder()), 1);
}

void ProjectSaveTest::unwritableFolderLeavesTheOldFile()
{
    const fs::path path = folder() / "a.ductus";
    QVERIFY(saveProject(sampleProject(1), path).ok());
    QVERIFY(::chmod(path.c_str(), 0666) == 0);
    QVERIFY(::chmod(folder().c_str(), 0555) == 0);
    const bool refused = inChild([&] {
        if (::geteuid() == 0 && ::seteuid(65534) != 0) // root may write anywhere
            return false;
        const Result<SaveReport> report = saveProject(sampleProject(2), path);
        return !report.ok() && report.error().code == ErrorCode::PermissionDenied;
    });
    QVERIFY(::chmod(folder().c_str(), 0755) == 0);
    QVERIFY(refused);
    QCOMPARE(difference(sampleProject(1), *openProject(path)), std::string());
    QCOMPARE(fileCount(folder()), 1);
}

void ProjectSaveTest::readOnlyFileIsNotReplaced()
{
    const fs::path path = folder() / "a.ductus";
    QVERIFY(saveProject(sampleProject(1), path).ok());
    QVERIFY(::chmod(path.c_str(), 0444) == 0);
    QVERIFY(::chmod(folder().c_str(), 0777) == 0);
    QVERIFY(inChild([&] {
        if (::geteuid() == 0 && ::seteuid(65534) != 0)
            return false;
        const Result<SaveReport> report = saveProject(sampleProject(2), path);
        return !report.ok() && report.error().code == ErrorCode::PermissionDenied;
    }));
    QCOMPARE(difference(sampleProject(1), *openProject(path)), std::string());
}

void ProjectSaveTest::missingFolderAndFolderAsTarget()
{
    QCOMPARE(saveProject(sampleProject(1), folder() / "no" / "a.ductus").error().code,
             ErrorCode::FileNotFound);
    QCOMPARE(saveProject(sampleProject(1), folder()).error().code, ErrorCode::NotAFile);
}

void ProjectSaveTest::leftoversOfKilledSavesAreRemoved()
{
    const fs::path path = folder() / "a.ductus";
    QVERIFY(inChild([&] {
        Result<TemporaryFile> file = TemporaryFile::createBeside(path);
        ::_exit(file.ok() && file->write(asBytes("half of a pro")).ok() ? 0 : 1); // without its destructor
        return false;
    }));
    Result<TemporaryFile> inUse = TemporaryFile::createBeside(path);
    const Result<TemporaryFile> ofAnother = TemporaryFile::createBeside(folder() / "b.ductus");
    QVERIFY(inUse.ok() && ofAnother.ok());
    QCOMPARE(fileCount(folder()), 3);
    QVERIFY(saveProject(sampleProject(1), path).ok());
    QVERIFY(fs::exists(inUse->path()));
    QVERIFY(fs::exists(ofAnother->path()));
    QCOMPARE(fileCount(folder()), 3); // these two and the project
}

void ProjectSaveTest::damageElsewhereDoesNotStopASave()
{
    Project project = sampleProject(1);
    StoredEntry broken = packedEntry("media/clip.bin", Bytes(1000, std::byte(3)));
    broken.crc32 ^= 1;
    project.keptEntries["media/clip.bin"] = broken;
    const std::string hash(64, 'a'); // a buffer whose content is not what its name says
    broken = packedEntry(bufferEntryName(hash), Bytes(1000, std::byte(4)));
    project.buffers.addEntry(broken);
    project.keptBuffers.insert(hash);
    const fs::path path = folder() / "a.ductus";
    QVERIFY(saveProject(project, path).ok());
    QVERIFY(openProject(path)->keptEntries.contains("media/clip.bin"));
}

void ProjectSaveTest::previousThatCannotBeKeptIsOnlyAWarning()
{
    const fs::path path = folder() / "a.ductus";
    QVERIFY(saveProject(sampleProject(1), path).ok());
    fs::create_directories(previousVersionPath(path) / "in the way");
    const Result<SaveReport> report = saveProject(sampleProject(2), path);
    QVERIFY(report.ok());
    QCOMPARE(report->warnings.size(), std::size_t(1));
    QCOMPARE(difference(sampleProject(2), *openProject(path)), std::string());
    QCOMPARE(fileCount(folder()), 2);
}

QTEST_APPLESS_MAIN(ProjectSaveTest)
#include "project_save_test.moc"
