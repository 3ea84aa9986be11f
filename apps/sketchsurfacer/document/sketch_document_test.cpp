#include "sketchsurfacer/document/sketch_document.h"

#include "document/commands/change_value.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "project/schema_check.h"
#include "sketchsurfacer/document/sketch_import.h"

#include <QtTest>

using namespace ductus;

namespace {

StrokeSet twoStrokes()
{
    StrokeSet set;
    set.strokes.resize(2);
    for (int i = 0; i < 2; ++i) {
        set.strokes[std::size_t(i)].id = StrokeId{i};
        set.strokes[std::size_t(i)].points = {
            {0.0, double(i), 0.0}, {1.0, double(i), 0.5}, {2.0, double(i), 0.25}};
    }
    return set;
}

std::shared_ptr<const SurfacingState> someResult()
{
    auto surface = std::make_shared<SurfaceResult>();
    surface->mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}};
    surface->mesh.triangles = {{0, 1, 2}};
    surface->triangleRegions = {0};
    surface->regions.resize(1);
    surface->regions[0].degree = 2;
    auto state = std::make_shared<SurfacingState>();
    state->surface = surface;
    return state;
}

} // namespace

class SketchDocumentTest : public QObject
{
    Q_OBJECT
private slots:
    void everyEditIsUndone();
    void aDragIsOneStep();
    void undoBringsTheOldResultBack();
    void aPreviewGivesWayToTheLastResult();
    void decisionsSurviveTheFile();
    void refusesBrokenDecisions();
    void readsTheBundledSamples();
    void startsFromWhatIsSeenWhenStrokesChange();
    void aReadingIsAnEdit();
};

void SketchDocumentTest::everyEditIsUndone()
{
    SketchDocument document;
    document.start(twoStrokes(), defaultSurfaceOptions(), "two");
    QVERIFY(!document.isModified());
    const std::uint64_t first = document.content().id;
    document.setRole({StrokeId{1}}, StrokeRole::Boundary);
    document.addScribble({ScribbleKind::Merge, {{0, 0, 0}, {1, 1, 0}}, 0});
    const StrokeId drawn = document.addStroke({{0, 0, 0}, {0, 1, 0}});
    QCOMPARE(drawn, StrokeId{2});
    document.deleteStrokes({StrokeId{0}});
    document.setUnit(0.001, UpAxis::Z);
    SurfaceOptions options = document.content().options;
    options.segmentation.simplicity = 0.5;
    document.setOptions("Change simplicity", options);
    document.removeScribble(0);
    QCOMPARE(document.undoStack()->count(), 7);
    QCOMPARE(document.strokes().strokes.size(), std::size_t(2));
    while (document.undoStack()->canUndo())
        document.undoStack()->undo();
    QCOMPARE(document.content().id, first);
    QCOMPARE(document.strokes().strokes.size(), std::size_t(2));
    QCOMPARE(document.strokes().strokes[1].role, StrokeRole::Surface);
    QCOMPARE(document.strokes().metresPerUnit, 1.0);
    QVERIFY(document.content().scribbles.empty());
    QVERIFY(!document.isModified());
    while (document.undoStack()->canRedo())
        document.undoStack()->redo();
    QCOMPARE(document.strokes().strokes.back().id, drawn);
    QCOMPARE(document.content().options.segmentation.simplicity, 0.5);
}

void SketchDocumentTest::aDragIsOneStep()
{
    SketchDocument document;
    document.start(twoStrokes(), defaultSurfaceOptions(), "two");
    const quint64 drag = nextDrag();
    for (double epsilon : {0.02, 0.03, 0.04}) {
        SurfaceOptions options = document.content().options;
        options.segmentation.epsilon = epsilon;
        document.setOptions("Change looseness", options, drag);
    }
    QCOMPARE(document.undoStack()->count(), 1);
    document.setOptions("Change looseness", document.content().options); // to what it is: no edit
    QCOMPARE(document.undoStack()->count(), 1);
    document.undoStack()->undo();
    QCOMPARE(document.content().options.segmentation.epsilon, 0.01);
}

void SketchDocumentTest::undoBringsTheOldResultBack()
{
    SketchDocument document;
    document.start(twoStrokes(), defaultSurfaceOptions(), "two");
    const auto first = someResult(), second = someResult();
    document.setResult(document.content(), first);
    QCOMPARE(document.shownResult(), first);
    document.addScribble({ScribbleKind::NewRegion, {{0, 0, 0}}, 0});
    QVERIFY(!document.isUpToDate());
    QCOMPARE(document.shownResult(), first); // the old one stays until there is a new one
    const SketchContent scribbled = document.content();
    document.undoStack()->undo();
    QCOMPARE(document.result(), first);
    document.setResult(scribbled, second); // comes late: kept, not shown
    QCOMPARE(document.shownResult(), first);
    document.undoStack()->redo();
    QCOMPARE(document.shownResult(), second);
}

void SketchDocumentTest::aPreviewGivesWayToTheLastResult()
{
    SketchDocument document;
    document.start(twoStrokes(), defaultSurfaceOptions(), "two");
    const auto first = someResult();
    document.setResult(document.content(), first);
    document.addScribble({ScribbleKind::NewRegion, {{0, 0, 0}}, 0});
    const auto preview = std::make_shared<const SurfacingState>();
    document.setPreview(document.content().id + 1, preview); // of another content
    QCOMPARE(document.shownResult(), first);
    document.setPreview(document.content().id, preview);
    QCOMPARE(document.shownResult(), preview);
    document.dropPreview();
    QCOMPARE(document.shownResult(), first);
}

void SketchDocumentTest::decisionsSurviveTheFile()
{
    SketchDocument document;
    document.start(twoStrokes(), defaultSurfaceOptions(), "two");
    SurfaceOptions options = document.content().options;
    options.segmentation.epsilon = 0.013;
    options.proxy.wrap.tightness = 0.3;
    options.skeletal.radius = 0.021;
    options.symmetry = SymmetryMode::Given;
    options.symmetryPlane = {Vec3::UnitZ(), 0.25};
    document.setOptions("Change", options);
    document.addScribble({ScribbleKind::SetDegree, {{0.1, 0.2, 1.0 / 3.0}}, 2});
    document.setRole({StrokeId{0}}, StrokeRole::Ignored);
    document.setResult(document.content(), someResult());

    const auto bytes = serializedProject(document.snapshot());
    QVERIFY2(bytes.ok(), bytes.ok() ? "" : bytes.error().message().c_str());
    const auto violations = projectSchemaViolations(std::as_bytes(std::span(bytes->bytes)), "test.ductus");
    QVERIFY(violations.ok());
    QVERIFY2(violations->empty(), violations->empty() ? "" : violations->front().c_str());
    auto project = parseProject(std::as_bytes(std::span(bytes->bytes)), "test.ductus");
    QVERIFY2(project.ok(), project.ok() ? "" : project.error().message().c_str());
    SketchDocument reopened;
    QVERIFY(reopened.load(std::move(*project), {}).ok());
    const SketchContent &content = reopened.content();
    QCOMPARE(content.options.segmentation.epsilon, 0.013);
    QCOMPARE(content.options.proxy.wrap.tightness, 0.3);
    QCOMPARE(content.options.skeletal.radius, 0.021);
    QCOMPARE(content.options.symmetry, SymmetryMode::Given);
    QCOMPARE(content.options.symmetryPlane.offset, 0.25);
    QVERIFY(content.scribbles == document.content().scribbles);
    QCOMPARE(reopened.strokes().strokes[0].role, StrokeRole::Ignored);
    QVERIFY(reopened.result());
    QCOMPARE(reopened.result()->surface->regions[0].degree, 2);
    QVERIFY(reopened.result()->surface->mesh.vertices == document.result()->surface->mesh.vertices);
}

void SketchDocumentTest::refusesBrokenDecisions()
{
    SketchDocument document;
    document.start(twoStrokes(), defaultSurfaceOptions(), "two");
    for (const char *broken :
         {"{}", "[{\"kind\":\"paint\",\"points\":[]}]", "[{\"kind\":\"merge\",\"points\":[[0,1]]}]",
          "[{\"kind\":\"merge\",\"points\":[[0,1,2]],\"degree\":99}]"}) {
        Project project = document.snapshot();
        auto content = std::make_shared<SketchSurfaceDocument>(*project.documents.at(0).sketchSurface);
        for (auto &[name, text] : content->settings.unknown)
            if (name == "scribbles")
                text = broken;
        project.documents.at(0).sketchSurface = content;
        const auto bytes = serializedProject(project);
        QVERIFY(bytes.ok());
        const auto violations =
            projectSchemaViolations(std::as_bytes(std::span(bytes->bytes)), "test.ductus");
        QVERIFY(violations.ok() && !violations->empty()); // other programs are told, too
        SketchDocument other;
        const Result<void> loaded = other.load(std::move(project), {});
        QVERIFY2(!loaded.ok(), broken);
        QCOMPARE(loaded.error().code, ErrorCode::Malformed);
        QVERIFY(other.isEmpty());
    }
}

void SketchDocumentTest::readsTheBundledSamples()
{
    const std::vector<SampleSketch> samples = bundledSamples();
    QVERIFY(samples.size() >= 6);
    for (const SampleSketch &sample : samples) {
        const Result<ImportedSketch> sketch = importSample(sample, JobControl());
        QVERIFY2(sketch.ok(), qPrintable(sample.id));
        QVERIFY(sketch->strokes.strokes.size() > 5);
        QVERIFY(!sample.title.isEmpty() && !sample.lesson.isEmpty());
    }
}

// As the solver leaves it: with labels to go on from.
static std::shared_ptr<const SurfacingState> labelledResult()
{
    auto state = std::make_shared<SurfacingState>(*someResult());
    state->association = std::make_shared<const Association>();
    state->labels = std::make_shared<const LabelSolution>();
    return state;
}

void SketchDocumentTest::startsFromWhatIsSeenWhenStrokesChange()
{
    SketchDocument document;
    document.start(twoStrokes(), defaultSurfaceOptions(), "two");
    const auto first = labelledResult(), second = labelledResult();
    document.setResult(document.content(), first);
    document.moveStrokes({StrokeId{0}}, {0, 0, 0.1});
    SketchContent madeOf;
    QCOMPARE(document.startingPoint(&madeOf), first);
    QVERIFY(!hasSameInput(madeOf, document.content()));
    document.setResult(document.content(), second);
    document.undoStack()->undo(); // first is seen again
    document.addStrokes({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {1, 1, 0}}});
    QCOMPARE(document.strokes().strokes.size(), std::size_t(4));
    QCOMPARE(document.startingPoint(&madeOf), first);
    SurfaceOptions options = document.content().options;
    options.proxy.wrap.tightness = 0.7; // another proxy: nothing to go on from
    document.setOptions("Change tightness", options);
    QVERIFY(!document.startingPoint(&madeOf));
    document.undoStack()->undo();
    QCOMPARE(document.startingPoint(&madeOf), first);
    document.startAnew();
    QVERIFY(!document.startingPoint(&madeOf));
}

void SketchDocumentTest::aReadingIsAnEdit()
{
    SketchDocument document;
    document.start(twoStrokes(), defaultSurfaceOptions(), "two");
    const auto first = labelledResult(), other = labelledResult(), final = labelledResult();
    document.setResult(document.content(), first);
    document.addScribble({ScribbleKind::NewRegion, {{0, 0, 0}}, 0});
    document.chooseReading(other);
    QVERIFY(!document.isUpToDate());
    QCOMPARE(document.content().reading->labelled, other);
    QVERIFY(document.content().scribbles.empty());
    document.setResult(document.content(), final);
    document.addScribble({ScribbleKind::Lock, {{0, 0, 0}}, 0});
    SketchContent madeOf;
    QCOMPARE(document.startingPoint(&madeOf), final); // and not the first, of the same strokes
    QVERIFY(hasSameInput(madeOf, document.content()));
    SurfaceOptions options = document.content().options;
    options.segmentation.epsilon = 0.02;
    document.setOptions("Change looseness", options);
    QVERIFY(!document.content().reading); // the regions are found anew
    for (int i = 0; i < 3; ++i)
        document.undoStack()->undo();
    QVERIFY(!document.content().reading);
    QCOMPARE(document.content().scribbles.size(), std::size_t(1));
}

QTEST_MAIN(SketchDocumentTest)
#include "sketch_document_test.moc"
