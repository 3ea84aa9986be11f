#include "document/document_files.h"
#include "document/testing/note_document.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace ductus;

class DocumentFilesTest : public QObject
{
    Q_OBJECT
private slots:
    void savesAndOpensAgain();
    void editsDuringTheSaveStay();
    void savesInARow();
    void reopeningTheOwnFileKeepsTheLock();
    void aFileOpenElsewhereIsReadOnly();
    void aMissingFileIsAnErrorAndLeavesNoLock();
    void aFailedSaveKeepsTheWorkUnsaved();
    void aDocumentThatWentIsNotTouched();
};

void DocumentFilesTest::savesAndOpensAgain()
{
    QTemporaryDir dir;
    const QString path = dir.filePath("h\u00fct \u5e3d.ductus");
    JobRunner runner;
    NoteDocument note;
    note.write("hello");
    int finished = 0;
    saveDocument(note, runner, path, [&](Result<SaveReport> report) {
        QVERIFY2(report.ok(), report ? "" : report.error().message().c_str());
        ++finished;
    });
    QVERIFY(runner.waitForAll(10000));
    QCOMPARE(finished, 1);
    QVERIFY(!note.isModified() && note.holdsLock());
    QCOMPARE(note.filePath(), path);
    note.write("hello again");
    saveDocument(note, runner, {}, [&](Result<SaveReport> report) { finished += report.ok() ? 1 : 0; });
    QVERIFY(runner.waitForAll(10000));
    QCOMPARE(finished, 2);
    note.reset(); // gives the lock back

    NoteDocument other;
    openDocument(other, runner, path, [&](Result<OpenNotes> notes) {
        QVERIFY(notes.ok() && notes->warnings.isEmpty());
        ++finished;
    });
    QVERIFY(runner.waitForAll(10000));
    QCOMPARE(finished, 3);
    QCOMPARE(other.text(), QString("hello again"));
    QVERIFY(!other.isReadOnly() && other.holdsLock());
}

void DocumentFilesTest::editsDuringTheSaveStay()
{
    QTemporaryDir dir;
    JobRunner runner;
    NoteDocument note;
    note.write("a");
    saveDocument(note, runner, dir.filePath("a.ductus"), [](Result<SaveReport>) {});
    note.write("b");
    QVERIFY(runner.waitForAll(10000));
    QVERIFY(note.isModified());
    QCOMPARE(note.text(), QString("b"));
    const Result<OpenedProject> onDisk = openProjectFile(dir.filePath("a.ductus"), "test", true);
    QVERIFY(onDisk.ok());
    QCOMPARE(onDisk->project.documents[0].name, std::string("a"));
}

void DocumentFilesTest::savesInARow()
{
    QTemporaryDir dir;
    JobRunner runner;
    NoteDocument note;
    QList<bool> results;
    for (int i = 0; i < 5; ++i) {
        note.write(QString::number(i));
        saveDocument(note, runner, dir.filePath("a.ductus"),
                     [&](Result<SaveReport> r) { results << r.ok(); });
    }
    QVERIFY(runner.waitForAll(20000));
    QCOMPARE(results,
             QList<bool>(5, true)); // the first takes the lock, the others find it taken by ourselves
    const Result<OpenedProject> onDisk = openProjectFile(dir.filePath("a.ductus"), "test", true);
    QVERIFY(onDisk.ok());
    QCOMPARE(onDisk->project.documents[0].name, std::string("4"));
    QVERIFY(!note.isModified());
}

void DocumentFilesTest::reopeningTheOwnFileKeepsTheLock()
{
    QTemporaryDir dir;
    JobRunner runner;
    NoteDocument note;
    note.write("a");
    saveDocument(note, runner, dir.filePath("a.ductus"), [](Result<SaveReport>) {});
    QVERIFY(runner.waitForAll(10000));
    note.write("not wanted");
    openDocument(note, runner, dir.filePath("a.ductus"),
                 [](Result<OpenNotes> notes) { QVERIFY(notes.ok()); });
    QVERIFY(runner.waitForAll(10000));
    QCOMPARE(note.text(), QString("a"));
    QVERIFY(note.holdsLock() && !note.isReadOnly());
}

void DocumentFilesTest::aFileOpenElsewhereIsReadOnly()
{
    QTemporaryDir dir;
    JobRunner runner;
    NoteDocument first;
    first.write("a");
    saveDocument(first, runner, dir.filePath("a.ductus"), [](Result<SaveReport>) {});
    QVERIFY(runner.waitForAll(10000));
    NoteDocument second;
    QStringList warnings;
    openDocument(second, runner, dir.filePath("a.ductus"),
                 [&](Result<OpenNotes> notes) { warnings = notes.ok() ? notes->warnings : QStringList(); });
    QVERIFY(runner.waitForAll(10000));
    QVERIFY(second.isReadOnly() && !second.holdsLock());
    QCOMPARE(warnings.size(), 1);
    second.write("b");
    std::optional<ErrorCode> refused;
    saveDocument(second, runner, {}, [&](Result<SaveReport> r) {
        if (!r)
            refused = r.error().code;
    });
    QVERIFY(runner.waitForAll(10000));
    QCOMPARE(refused, std::optional(ErrorCode::Locked));
    bool isSaved = false;
    saveDocument(second, runner, dir.filePath("b.ductus"), [&](Result<SaveReport> r) { isSaved = r.ok(); });
    QVERIFY(runner.waitForAll(10000));
    QVERIFY(isSaved && !second.isReadOnly() && !second.isModified());
}

void DocumentFilesTest::aMissingFileIsAnErrorAndLeavesNoLock()
{
    QTemporaryDir dir;
    const Result<OpenedProject> opened = openProjectFile(dir.filePath("none.ductus"), "test");
    QVERIFY(!opened);
    QCOMPARE(opened.error().code, ErrorCode::FileNotFound);
    QVERIFY(QDir(dir.path()).isEmpty());
}

void DocumentFilesTest::aFailedSaveKeepsTheWorkUnsaved()
{
    QTemporaryDir dir;
    JobRunner runner;
    NoteDocument note;
    note.write("a");
    bool failed = false;
    saveDocument(note, runner, dir.filePath("no such folder/a.ductus"),
                 [&](Result<SaveReport> report) { failed = !report.ok(); });
    QVERIFY(runner.waitForAll(10000));
    QVERIFY(failed);
    QVERIFY(note.isModified() && note.filePath().isEmpty());
}

void DocumentFilesTest::aDocumentThatWentIsNotTouched()
{
    QTemporaryDir dir;
    JobRunner runner;
    auto note = std::make_unique<NoteDocument>();
    note->write("a");
    saveDocument(*note, runner, dir.filePath("a.ductus"), [](Result<SaveReport>) {});
    openDocument(*note, runner, dir.filePath("b.ductus"),
                 [](Result<OpenNotes> notes) { QVERIFY(!notes.ok()); });
    note.reset();
    QVERIFY(runner.waitForAll(10000));
    QVERIFY(QFile::exists(dir.filePath("a.ductus")));
}

QTEST_GUILESS_MAIN(DocumentFilesTest)
#include "document_files_test.moc"
