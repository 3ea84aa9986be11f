#include "document/recovery/autosave.h"

#include "document/project_picture.h"
#include "document/recovery/recovery_list.h"
#include "document/recovery/state_folder.h"
#include "document/testing/note_document.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

namespace {

const AutosaveTimes quick{30, 20, 200, 60};

QStringList copiesIn(const QString &folder)
{
    return QDir(folder).entryList({"*.ductus"}, QDir::Files);
}

} // namespace

class AutosaveTest : public QObject
{
    Q_OBJECT
private slots:
    void unsavedWorkIsCopied();
    void savingRemovesTheCopy();
    void closingWithoutSavingRemovesTheCopy();
    void itWaitsWhileBusyButNotForEver();
    void aFailureIsToldAndTriedAgain();
    void aCopyInUseIsNotOffered();
    void whatACrashLeftIsFoundAndOpened();
    void workOnAFileComesBackAsWorkOnIt();
    void aDamagedCopyIsListedToo();
    void thumbnailsAreBounded();
    void theStateFolderFollowsTheSystem();
};

void AutosaveTest::unsavedWorkIsCopied()
{
    QTemporaryDir dir;
    JobRunner runner;
    NoteDocument note;
    Autosave autosave(note, runner, dir.filePath("state/autosave"));
    autosave.setTimes(quick);
    QSignalSpy saved(&autosave, &Autosave::saved);
    QTest::qWait(80);
    QCOMPARE(saved.count(), 0); // nothing to save
    note.write("a");
    QVERIFY(saved.wait(5000));
    QVERIFY(note.isModified()); // still not saved by the user
    QCOMPARE(copiesIn(dir.filePath("state/autosave")).size(), 1);
    note.write("b");
    QVERIFY(saved.wait(5000));
    QCOMPARE(copiesIn(dir.filePath("state/autosave")).size(), 1);
    const Result<OpenedProject> copy = openProjectFile(autosave.copyPath(), "test", true);
    QVERIFY(copy.ok());
    QCOMPARE(copy->project.documents[0].name, std::string("b"));
    QTest::qWait(150);
    QCOMPARE(saved.count(), 2); // nothing new, nothing written
    QCOMPARE(runner.isBusy(), false);
}

void AutosaveTest::savingRemovesTheCopy()
{
    QTemporaryDir dir;
    JobRunner runner;
    NoteDocument note;
    Autosave autosave(note, runner, dir.filePath("autosave"));
    note.write("a");
    autosave.saveNow();
    QVERIFY(runner.waitForAll(5000));
    QCOMPARE(copiesIn(dir.filePath("autosave")).size(), 1);
    saveDocument(note, runner, dir.filePath("a.ductus"), [](Result<SaveReport>) {});
    QVERIFY(runner.waitForAll(5000));
    QCOMPARE(QDir(dir.filePath("autosave")).entryList(QDir::Files), QStringList());
}

void AutosaveTest::closingWithoutSavingRemovesTheCopy()
{
    QTemporaryDir dir;
    JobRunner runner;
    NoteDocument note;
    Autosave autosave(note, runner, dir.filePath("autosave"));
    note.write("a");
    autosave.saveNow();
    autosave.discard(); // while it is being written
    QVERIFY(runner.waitForAll(5000));
    QCOMPARE(copiesIn(dir.filePath("autosave")), QStringList());
}

void AutosaveTest::itWaitsWhileBusyButNotForEver()
{
    QTemporaryDir dir;
    JobRunner runner;
    NoteDocument note;
    Autosave autosave(note, runner, dir.filePath("autosave"));
    autosave.setTimes(quick);
    bool isDrawing = true;
    int asked = 0;
    autosave.setBusyCheck([&] {
        ++asked;
        return isDrawing;
    });
    QSignalSpy saved(&autosave, &Autosave::saved);
    note.write("a");
    QTRY_VERIFY(asked >= 3);
    QCOMPARE(saved.count(), 0);
    isDrawing = false;
    QVERIFY(saved.wait(5000));
    isDrawing = true;
    note.write("b");
    QVERIFY(saved.wait(5000)); // after longestPostponedMs
}

void AutosaveTest::aFailureIsToldAndTriedAgain()
{
    QTemporaryDir dir;
    QFile obstacle(dir.filePath("autosave")); // a file where the folder should be
    QVERIFY(obstacle.open(QIODevice::WriteOnly));
    obstacle.close();
    JobRunner runner;
    NoteDocument note;
    Autosave autosave(note, runner, dir.filePath("autosave"));
    autosave.setTimes(quick);
    QSignalSpy failed(&autosave, &Autosave::failed);
    QSignalSpy saved(&autosave, &Autosave::saved);
    note.write("a");
    QVERIFY(failed.wait(5000));
    QVERIFY(obstacle.remove());
    QVERIFY(saved.count() > 0 || saved.wait(5000));
}

void AutosaveTest::aCopyInUseIsNotOffered()
{
    QTemporaryDir dir;
    JobRunner runner;
    NoteDocument note;
    Autosave autosave(note, runner, dir.filePath("autosave"));
    note.write("a");
    autosave.saveNow();
    QVERIFY(runner.waitForAll(5000));
    QCOMPARE(recoveredFiles(dir.filePath("autosave")).size(), 0);
}

void AutosaveTest::whatACrashLeftIsFoundAndOpened()
{
    QTemporaryDir dir;
    JobRunner runner;
    {
        NoteDocument note;
        note.setUntitledName("my hat");
        Autosave autosave(note, runner, dir.filePath("autosave"));
        note.write("unsaved");
        autosave.saveNow();
        QVERIFY(runner.waitForAll(5000));
    } // the copy stays, nobody holds it
    const QList<RecoveredFile> files = recoveredFiles(dir.filePath("autosave"));
    QCOMPARE(files.size(), 1);
    QCOMPARE(files[0].displayName, QString("my hat"));
    QCOMPARE(files[0].originalPath, QString());
    NoteDocument note;
    Result<OpenedProject> opened = openProjectFile(files[0].copy, "test");
    QVERIFY(opened.ok());
    QVERIFY(adoptRecovered(note, std::move(opened).value(), files[0]).ok());
    QCOMPARE(note.text(), QString("unsaved"));
    QVERIFY(note.isModified() && note.filePath().isEmpty());
    QCOMPARE(note.displayName(), QString("my hat"));
    QVERIFY(discardRecovered(files[0]).ok());
    QVERIFY(recoveredFiles(dir.filePath("autosave")).isEmpty());
    QCOMPARE(QDir(dir.filePath("autosave")).entryList(QDir::Files), QStringList());
}

void AutosaveTest::workOnAFileComesBackAsWorkOnIt()
{
    QTemporaryDir dir;
    JobRunner runner;
    const QString path = dir.filePath("a.ductus");
    {
        NoteDocument note;
        Autosave autosave(note, runner, dir.filePath("autosave"));
        note.write("saved");
        saveDocument(note, runner, path, [](Result<SaveReport>) {});
        QVERIFY(runner.waitForAll(5000));
        note.write("unsaved");
        autosave.saveNow();
        QVERIFY(runner.waitForAll(5000));
    }
    const QList<RecoveredFile> files = recoveredFiles(dir.filePath("autosave"));
    QCOMPARE(files.size(), 1);
    QCOMPARE(files[0].originalPath, path);
    NoteDocument note;
    QVERIFY(adoptRecovered(note, openProjectFile(files[0].copy, "test").value(), files[0]).ok());
    QCOMPARE(note.filePath(), path);
    QVERIFY(note.isModified() && note.holdsLock());
    bool isSaved = false;
    saveDocument(note, runner, {}, [&](Result<SaveReport> r) { isSaved = r.ok(); });
    QVERIFY(runner.waitForAll(5000));
    QVERIFY(isSaved);
    QCOMPARE(openProjectFile(path, "test", true)->project.documents[0].name, std::string("unsaved"));
}

void AutosaveTest::aDamagedCopyIsListedToo()
{
    QTemporaryDir dir;
    QFile file(dir.filePath("torn.ductus"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("PK torn") > 0);
    file.close();
    const QList<RecoveredFile> files = recoveredFiles(dir.path());
    QCOMPARE(files.size(), 1);
    QCOMPARE(files[0].displayName, QString("torn"));
    QVERIFY(files[0].thumbnail.isNull());
}

void AutosaveTest::thumbnailsAreBounded()
{
    Project project;
    QImage picture(1000, 500, QImage::Format_RGB32);
    picture.fill(Qt::red);
    setProjectThumbnail(project, picture);
    const QImage read = projectThumbnail(project);
    QCOMPARE(read.size(), QSize(256, 128));
    QCOMPARE(read.pixelColor(100, 60), QColor(Qt::red));
    project.thumbnail = storedEntry("thumbnail.png", asBytes("no picture"));
    QVERIFY(projectThumbnail(project).isNull());
    setProjectThumbnail(project, {});
    QVERIFY(!project.thumbnail);
}

void AutosaveTest::theStateFolderFollowsTheSystem()
{
    qputenv("XDG_STATE_HOME", "/somewhere/state");
    QCOMPARE(stateFolder("sketchsurfacer", "autosave"), QString("/somewhere/state/sketchsurfacer/autosave"));
    qputenv("XDG_STATE_HOME", "relative");
    QCOMPARE(stateFolder("a", "b"), QDir::homePath() + "/.local/state/a/b");
    qunsetenv("XDG_STATE_HOME");
}

QTEST_GUILESS_MAIN(AutosaveTest)
#include "autosave_test.moc"
