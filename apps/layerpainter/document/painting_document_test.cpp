// The document: undo restores exactly, drags are one step, the log plays again to the same bytes.
#include "layerpainter/document/painting_document.h"

#include "document/commands/change_value.h"
#include "document/document_files.h"
#include "layerpainter/document/painting_project.h"
#include "painting/testing/random_actions.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "project/testing/sample_project.h"
#include "support/mesh_zoo.h"

#include <QDir>
#include <QSignalSpy>
#include <QtTest>

using namespace ductus;

namespace {

std::string print(const PaintingDocument &document)
{
    return paintingFingerprint(document.painting());
}

Bytes bytesOf(const Painting &painting)
{
    return serializedProject(projectOf(painting, "p"))->bytes;
}

act::SetProperties opacity(LayerId layer, double value)
{
    act::SetProperties edit;
    edit.layer = layer;
    edit.opacity = value;
    return edit;
}

Result<Painting> replayedLog(const std::string &text, const Painting &start)
{
    const auto log = parsedLog(text, "log");
    if (!log)
        return log.error();
    return replayed(*log, "log", [&](const std::string &) { return Result<Painting>(start); }, {});
}

} // namespace

class PaintingDocumentTest : public QObject
{
    Q_OBJECT
private slots:
    void undoRestoresExactly();
    void theLogPlaysAgainToTheSameBytes();
    void dragsAreOneStep();
    void refusedActionsChangeNothing();
    void comesBackFromAProject();
    void untouchedProjectsStayAsTheyWere();
    void surfacesOfASketchAreWhatIsPaintedOn();
    void saysWhatChanged();
};

void PaintingDocumentTest::undoRestoresExactly()
{
    PaintingDocument document;
    document.start(samplePainting(1), "sample", "s.ductus");
    Random random(7);
    std::vector<std::string> prints{print(document)};
    while (prints.size() < 60)
        if (document.perform(randomAction(document.painting(), random)))
            prints.push_back(print(document));
    QCOMPARE(document.undoStack()->count(), 59);
    for (std::size_t i = prints.size() - 1; i-- > 0;) {
        document.undoStack()->undo();
        QCOMPARE(print(document), prints[i]);
    }
    for (std::size_t i = 1; i < prints.size(); ++i) {
        document.undoStack()->redo();
        QCOMPARE(print(document), prints[i]);
    }
    QVERIFY(!document.undoStack()->text(0).isEmpty());
}

void PaintingDocumentTest::theLogPlaysAgainToTheSameBytes()
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Random random(seed);
        const Painting start = samplePainting(seed);
        PaintingDocument document;
        document.start(start, "sample", "s.ductus");
        quint64 drag = 0;
        for (int step = 0; step < 120; ++step) {
            const int dice = random.index(10);
            if (dice == 0)
                document.undoStack()->undo();
            else if (dice == 1)
                document.undoStack()->redo();
            else if (dice == 2 && !document.painting().layers().empty()) {
                drag = nextDrag();
                const LayerId layer = document.painting().layers().front()->id;
                for (int k = 0; k < 5; ++k)
                    (void)document.perform(opacity(layer, random.uniform()), drag);
            } else
                (void)document.perform(randomAction(document.painting(), random));
        }
        const Result<Painting> again = replayedLog(document.actionLog(), start);
        QVERIFY2(again.ok(), again.ok() ? "" : again.error().message().c_str());
        QVERIFY(bytesOf(*again) == bytesOf(document.painting()));
    }
}

void PaintingDocumentTest::dragsAreOneStep()
{
    PaintingDocument document;
    document.start({}, "new");
    const auto made = document.perform(act::AddStack{"tree"});
    QVERIFY(made.ok() && made->size() == 2);
    const LayerId layer{made->at(1)};
    const std::string before = print(document);
    const quint64 drag = nextDrag();
    for (int i = 1; i <= 20; ++i)
        QVERIFY(document.perform(opacity(layer, i / 25.0), drag).ok());
    QCOMPARE(document.undoStack()->count(), 2);
    QCOMPARE(document.logLength(), 2);
    QCOMPARE(document.painting().findLayer(layer)->properties.opacity, 0.8);
    document.undoStack()->undo();
    QCOMPARE(print(document), before);
    document.undoStack()->redo();
    QVERIFY(document.perform(opacity(layer, 0.1), nextDrag()).ok());
    QCOMPARE(document.undoStack()->count(), 3);
    // Saved in the middle of a drag: what follows is a step of its own.
    const quint64 other = nextDrag();
    QVERIFY(document.perform(opacity(layer, 0.2), other).ok());
    document.undoStack()->setClean();
    QVERIFY(document.perform(opacity(layer, 0.3), other).ok());
    QCOMPARE(document.undoStack()->count(), 5);
    QVERIFY(bytesOf(*replayedLog(document.actionLog(), {})) == bytesOf(document.painting()));
}

void PaintingDocumentTest::refusedActionsChangeNothing()
{
    PaintingDocument document;
    document.start({}, "new");
    QSignalSpy refusals(&document, &PaintingDocument::refused);
    QVERIFY(!document.perform(act::RemoveLayer{LayerId{5}}).ok());
    QCOMPARE(refusals.size(), 1);
    QCOMPARE(document.undoStack()->count(), 0);
    QCOMPARE(document.logLength(), 0);
    QVERIFY(!document.isModified());
}

void PaintingDocumentTest::comesBackFromAProject()
{
    PaintingDocument document;
    document.start(samplePainting(1), "sample");
    QVERIFY(document.perform(act::AddStack{"new"}).ok());
    const Bytes bytes = serializedProject(document.snapshot())->bytes;
    PaintingDocument opened;
    QVERIFY(opened.load(*parseProject(bytes, "a.ductus", knownDocuments()), {}).ok());
    QCOMPARE(print(opened), print(document));
    QVERIFY(!opened.isModified());
    // Edited and saved again it stays the same document.
    QVERIFY(opened.perform(act::AddStack{"newer"}).ok());
    const Project again =
        *parseProject(serializedProject(opened.snapshot())->bytes, "b.ductus", knownDocuments());
    QCOMPARE(again.documents.size(), std::size_t(1));
    QCOMPARE(paintingFingerprint(paintingFromProject(again)->content->painting()), print(opened));

    PaintingDocument other;
    other.start({}, "kept");
    QVERIFY(!other.load(Project(), {}).ok());
    QCOMPARE(other.displayName(), QString("kept"));
}

void PaintingDocumentTest::surfacesOfASketchAreWhatIsPaintedOn()
{
    Project project;
    project.id = Uuid::create();
    ProjectDocument sketch;
    sketch.id = Uuid::create();
    sketch.kind = sketchSurfaceKind;
    sketch.name = "bottle";
    SketchSurfaceDocument content = sampleSketchSurface(3);
    content.surface.emplace();
    content.surface->mesh = zoo::box();
    content.strokes.metresPerUnit = 0.001;
    sketch.sketchSurface = std::make_shared<const SketchSurfaceDocument>(content);
    project.documents.push_back(sketch);
    PaintingDocument document;
    const Result<void> loaded = document.load(project, {});
    QVERIFY2(loaded.ok(), loaded ? "" : loaded.error().message().c_str());
    QCOMPARE(document.painting().stacks.size(), std::size_t(1));
    QCOMPARE(document.painting().stacks.front().name, std::string("bottle"));
    QCOMPARE(document.painting().metresPerUnit, 0.001);
    QCOMPARE(document.painting().stacks.front().substrate->elementCount(), 1);
    // Saved, the painting stands beside the sketch, in the same project, and is found again.
    QVERIFY(document.perform(act::AddStack{"glaze"}).ok());
    const Project saved =
        *parseProject(serializedProject(document.snapshot())->bytes, "b.ductus", knownDocuments());
    QCOMPARE(saved.documents.size(), std::size_t(2));
    QVERIFY(saved.id == project.id && saved.documents.front().sketchSurface);
    QCOMPARE(paintingFromProject(saved)->content->painting().stacks.size(), std::size_t(2));

    content.surface.reset(); // nothing to paint on yet
    project.documents.front().sketchSurface = std::make_shared<const SketchSurfaceDocument>(content);
    QVERIFY(!PaintingDocument().load(project, {}).ok());
}

void PaintingDocumentTest::untouchedProjectsStayAsTheyWere()
{
    const Bytes bytes = bytesOf(samplePainting(1));
    PaintingDocument document;
    QVERIFY(
        document.load(*parseProject(bytes, "p.ductus", knownDocuments()), QDir::temp().filePath("p.ductus"))
            .ok());
    const Result<SerializedProject> saved = serializedProject(document.snapshot());
    QVERIFY(saved.ok());
    QCOMPARE(saved->packedBuffers, 0);
    QVERIFY(saved->bytes == bytes);
}

void PaintingDocumentTest::saysWhatChanged()
{
    PaintingDocument document;
    document.start(samplePainting(1), "sample");
    PaintingChanged last;
    connect(&document, &Document::changed, this, [&](const ChangeEvent &event) {
        if (const auto *change = event.as<PaintingChanged>())
            last = *change;
    });
    QVERIFY(document.perform(act::AddStack{"new"}).ok());
    QVERIFY(last.layers && !last.elements && !last.properties);
    const LayerId layer = document.painting().stacks[0].substrate->id;
    QVERIFY(document.perform(opacity(layer, 0.5)).ok());
    QVERIFY(last.properties && !last.layers);
    QVERIFY(document.perform(act::ApplyLook{document.painting().looks[0].id}).ok());
    QVERIFY(last.properties && last.looks);
}

QTEST_GUILESS_MAIN(PaintingDocumentTest)
#include "painting_document_test.moc"
