#include "document/testing/note_document.h"

#include "document/commands/function_command.h"

#include <QSignalSpy>
#include <QtTest>

using namespace ductus;

class DocumentTest : public QObject
{
    Q_OBJECT
private slots:
    void undoAndRedoTellTheViews();
    void oneDragIsOneStep();
    void aDragBackLeavesNothing();
    void typedValuesAreSeparateSteps();
    void functionCommandsGoBothWays();
    void savedStateIsKnownThroughUndo();
    void editingDuringASaveStaysUnsaved();
    void mergingDuringASaveStaysUnsaved();
    void touchIsUnsavedWorkToo();
    void aFailedLoadChangesNothing();
    void loadingKeepsWhatIsUnknown();
    void resetStartsANewProject();
    void namesComeFromTheFile();
};

void DocumentTest::undoAndRedoTellTheViews()
{
    NoteDocument note;
    QStringList heard;
    connect(&note, &Document::changed, this, [&](const ChangeEvent &event) {
        if (const auto *change = event.as<NoteChanged>())
            heard << change->text;
    });
    note.write("a");
    note.write("b");
    note.undoStack()->undo();
    note.undoStack()->redo();
    QCOMPARE(heard, (QStringList{"a", "b", "a", "b"}));
    QCOMPARE(note.undoStack()->undoText(), QString("Write"));
}

void DocumentTest::oneDragIsOneStep()
{
    NoteDocument note;
    note.write("start");
    const quint64 drag = nextDrag();
    for (const char *text : {"s", "sl", "sli", "slide"})
        note.write(QString::fromLatin1(text), drag);
    QCOMPARE(note.undoStack()->count(), 2);
    note.write("slides", nextDrag());
    QCOMPARE(note.undoStack()->count(), 3);
    note.undoStack()->undo();
    QCOMPARE(note.text(), QString("slide"));
    note.undoStack()->undo();
    QCOMPARE(note.text(), QString("start"));
}

void DocumentTest::aDragBackLeavesNothing()
{
    NoteDocument note;
    const quint64 drag = nextDrag();
    note.write("there", drag);
    QVERIFY(note.isModified());
    note.write("", drag);
    QCOMPARE(note.undoStack()->count(), 0);
    QVERIFY(!note.isModified());
    note.write(""); // the present value
    QCOMPARE(note.undoStack()->count(), 0);
}

void DocumentTest::typedValuesAreSeparateSteps()
{
    NoteDocument note;
    note.write("1");
    note.write("12");
    QCOMPARE(note.undoStack()->count(), 2);
}

void DocumentTest::functionCommandsGoBothWays()
{
    NoteDocument note;
    int value = 0;
    note.undoStack()->push(new FunctionCommand(
        "Add", [&] { ++value; }, [&] { --value; }));
    QCOMPARE(value, 1);
    note.undoStack()->undo();
    QCOMPARE(value, 0);
}

void DocumentTest::savedStateIsKnownThroughUndo()
{
    NoteDocument note;
    QSignalSpy modified(&note, &Document::modifiedChanged);
    note.write("a");
    QVERIFY(note.isModified());
    note.markSaved("/x/a.ductus", note.revision(), {});
    QVERIFY(!note.isModified());
    note.undoStack()->undo();
    QVERIFY(note.isModified());
    note.undoStack()->redo();
    QVERIFY(!note.isModified());
    QCOMPARE(modified.count(), 4);
}

void DocumentTest::editingDuringASaveStaysUnsaved()
{
    NoteDocument note;
    note.write("a");
    const quint64 saved = note.revision();
    note.write("b");
    note.markSaved("/x/a.ductus", saved, {});
    QVERIFY(note.isModified());
    QCOMPARE(note.filePath(), QString("/x/a.ductus"));
}

void DocumentTest::mergingDuringASaveStaysUnsaved()
{
    // The stack's index does not move, but the content does.
    NoteDocument note;
    const quint64 drag = nextDrag();
    note.write("a", drag);
    const quint64 saved = note.revision();
    note.write("ab", drag);
    QCOMPARE(note.undoStack()->count(), 1);
    note.markSaved("/x/a.ductus", saved, {});
    QVERIFY(note.isModified());
}

void DocumentTest::touchIsUnsavedWorkToo()
{
    NoteDocument note;
    note.touch();
    QVERIFY(note.isModified());
    note.markSaved("/x/a.ductus", note.revision(), {});
    QVERIFY(!note.isModified());
}

void DocumentTest::aFailedLoadChangesNothing()
{
    NoteDocument note;
    note.write("mine");
    const Uuid id = note.project().id;
    QVERIFY(!note.load(Project(), "/x/empty.ductus"));
    QCOMPARE(note.text(), QString("mine"));
    QCOMPARE(note.filePath(), QString());
    QVERIFY(note.project().id == id);
    QCOMPARE(note.undoStack()->count(), 1);
}

void DocumentTest::loadingKeepsWhatIsUnknown()
{
    Project project = sampleProject(7);
    project.unknown.push_back({"later", "{\"x\": 1.50}"});
    NoteDocument note;
    note.write("old");
    QVERIFY(note.load(project, "/x/hat.ductus"));
    QCOMPARE(note.undoStack()->count(), 0);
    QVERIFY(!note.isModified());
    note.write("new name");
    const Project saved = note.snapshot();
    QCOMPARE(saved.documents.size(), std::size_t(2));
    QCOMPARE(saved.documents[0].name, std::string("new name"));
    QVERIFY(saved.unknown == project.unknown);
    project.documents[0].name = "new name";
    QCOMPARE(difference(saved, project), std::string());
}

void DocumentTest::resetStartsANewProject()
{
    NoteDocument note;
    QVERIFY(note.load(sampleProject(3), "/x/hat.ductus"));
    note.setReadOnly("locked");
    note.reset();
    QCOMPARE(note.text(), QString());
    QVERIFY(note.filePath().isEmpty() && !note.isReadOnly() && !note.isModified());
    QVERIFY(!(note.project().id == sampleProject(3).id));
}

void DocumentTest::namesComeFromTheFile()
{
    NoteDocument note;
    QCOMPARE(note.displayName(), QString("Untitled"));
    note.setUntitledName("hat");
    QCOMPARE(note.displayName(), QString("hat"));
    note.markSaved("/x/big hat.v2.ductus", note.revision(), {});
    QCOMPARE(note.displayName(), QString("big hat.v2"));
}

QTEST_GUILESS_MAIN(DocumentTest)
#include "document_test.moc"
