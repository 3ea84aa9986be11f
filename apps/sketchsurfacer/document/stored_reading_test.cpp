#include "sketchsurfacer/document/stored_reading.h"

#include "project/project_reader.h"
#include "project/project_writer.h"
#include "project/schema_check.h"
#include "sketchsurfacer/document/sketch_import.h"
#include "sketchsurfacer/document/surfacing_jobs.h"
#include "surfacing/pipeline/ambiguity.h"

#include <QSignalSpy>
#include <QtTest>

using namespace ductus;

namespace {

constexpr int solveMilliseconds = 240'000; // on a busy machine

// All of the sketch one region more than it has: the largest is parted by a plane, as no solver would.
Segmentation partedReading(const SurfacingState &state)
{
    Segmentation reading = state.labels->segmentation;
    std::vector<int> sizes(reading.models.size(), 0);
    for (int label : reading.labels)
        ++sizes[std::size_t(label)];
    const int largest = int(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    const std::vector<Vec3> &vertices = state.proxy->proxy.mesh.vertices;
    std::vector<double> along;
    for (std::size_t v = 0; v < vertices.size(); ++v)
        if (reading.labels[v] == largest)
            along.push_back(vertices[v].x());
    std::nth_element(along.begin(), along.begin() + std::ptrdiff_t(along.size() / 2), along.end());
    for (std::size_t v = 0; v < vertices.size(); ++v)
        if (reading.labels[v] == largest && vertices[v].x() > along[along.size() / 2])
            reading.labels[v] = int(reading.models.size());
    reading.models.push_back(reading.models[std::size_t(largest)]);
    return reading;
}

} // namespace

class StoredReadingTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void comesBackOnTheSameProxy();
    void comesBackOnAnotherProxy();
    void survivesTheFileAndTakesScribbles();
    void isGoneWithTheReading();

private:
    SketchContent mContent;
    std::shared_ptr<const SurfacingState> mChosen;
};

void StoredReadingTest::initTestCase()
{
    for (const SampleSketch &sample : bundledSamples()) {
        if (sample.id != "bent-leaf")
            continue;
        const Result<ImportedSketch> sketch = importSample(sample, JobControl());
        QVERIFY(sketch.ok());
        mContent.strokes = std::make_shared<const StrokeSet>(sketch->strokes);
        mContent.options = sketch->options;
    }
    mContent.options.segmentation.runs = 1;
    mContent.options.proxy.targetVertices = 2500; // the file does not keep this: there the proxy is another
    QVERIFY(!mContent.strokes->strokes.empty());
    const auto prepared = prepareSurfacing(*mContent.strokes, {}, mContent.options, JobControl());
    QVERIFY2(prepared.ok(), prepared.ok() ? "" : prepared.error().message().c_str());
    const auto labelled = solveLabels(*prepared, {}, mContent.options, JobControl());
    QVERIFY(labelled.ok());
    auto chosen = withAlternative(*labelled, partedReading(*labelled), JobControl());
    QVERIFY(chosen.ok());
    QVERIFY(chosen->labels->segmentation.labels != labelled->labels->segmentation.labels);
    mChosen = std::make_shared<const SurfacingState>(std::move(*chosen));
}

void StoredReadingTest::comesBackOnTheSameProxy()
{
    const StoredReading stored = storedReading(*mChosen);
    const auto again = withReading(*mChosen, stored, JobControl());
    QVERIFY(again.ok());
    const Segmentation &before = mChosen->labels->segmentation, &after = again->labels->segmentation;
    QCOMPARE(after.models.size(), before.models.size());
    for (std::size_t v = 0; v < before.labels.size(); ++v) {
        const ImplicitPolynomial &p = before.models[std::size_t(before.labels[v])];
        const ImplicitPolynomial &q = after.models[std::size_t(after.labels[v])];
        QCOMPARE(q.degree, p.degree);
        const Vec3 at = mChosen->proxy->proxy.mesh.vertices[v] + Vec3(0.01, -0.02, 0.015);
        QVERIFY(std::abs(p.value(at) - q.value(at)) < 1e-9 * (1.0 + std::abs(p.value(at))));
        if (v > 0) // the same borders, whatever the numbers
            QCOMPARE(after.labels[v] == after.labels[v - 1], before.labels[v] == before.labels[v - 1]);
    }
    QVERIFY(after.energy > 0.0);
    QCOMPARE(withReading(*mChosen, {}, JobControl()).error().code, ErrorCode::Malformed);
}

void StoredReadingTest::comesBackOnAnotherProxy()
{
    SurfaceOptions coarse = mContent.options;
    coarse.proxy.targetVertices = coarse.proxy.targetVertices / 2;
    const auto prepared = prepareSurfacing(*mContent.strokes, {}, coarse, JobControl());
    QVERIFY(prepared.ok());
    QVERIFY(prepared->proxy->proxy.mesh.vertexCount() != mChosen->proxy->proxy.mesh.vertexCount());
    const auto again = withReading(*prepared, storedReading(*mChosen), JobControl());
    QVERIFY(again.ok());
    QCOMPARE(again->labels->segmentation.models.size(), mChosen->labels->segmentation.models.size());
    QCOMPARE(int(again->labels->segmentation.labels.size()), prepared->proxy->proxy.mesh.vertexCount());
}

void StoredReadingTest::survivesTheFileAndTakesScribbles()
{
    SketchDocument document;
    document.start(*mContent.strokes, mContent.options, "leaf");
    document.chooseReading(mChosen);
    const auto bytes = serializedProject(document.snapshot());
    QVERIFY2(bytes.ok(), bytes.ok() ? "" : bytes.error().message().c_str());
    const auto violations = projectSchemaViolations(std::as_bytes(std::span(bytes->bytes)), "leaf.ductus");
    QVERIFY(violations.ok() && violations->empty());
    auto project = parseProject(std::as_bytes(std::span(bytes->bytes)), "leaf.ductus");
    QVERIFY2(project.ok(), project.ok() ? "" : project.error().message().c_str());

    JobRunner runner;
    SketchDocument reopened;
    SurfacingJobs jobs(reopened, runner);
    QSignalSpy failed(&jobs, &SurfacingJobs::failed);
    QVERIFY(reopened.load(std::move(*project), {}).ok());
    QVERIFY(reopened.content().reading && !reopened.content().reading->labelled);
    const Vec3 place = mChosen->sketch->frame.inputFromUnit(mChosen->proxy->proxy.mesh.vertices.front());
    reopened.addScribble({ScribbleKind::Lock, {place}, 0});
    QCOMPARE(reopened.snapshot().documents.at(0).sketchSurface->reading->labels,
             storedReading(*mChosen).labels); // saved before it was made again: nothing is lost
    jobs.start();
    QVERIFY(QTest::qWaitFor([&] { return reopened.isUpToDate() || failed.count() > 0; }, solveMilliseconds));
    QCOMPARE(failed.count(), 0);
    const LabelSolution &before = *reopened.result()->labels->before;
    QCOMPARE(before.segmentation.models.size(), mChosen->labels->segmentation.models.size());
    const StoredReading again = *reopened.snapshot().documents.at(0).sketchSurface->reading;
    QVERIFY(again.points.size() > storedReading(*mChosen).points.size());
    QCOMPARE(again.models.size(), mChosen->labels->segmentation.models.size());
}

// Undone, or found anew: the file tells of none.
void StoredReadingTest::isGoneWithTheReading()
{
    SketchDocument document;
    document.start(*mContent.strokes, mContent.options, "leaf");
    document.chooseReading(mChosen);
    QVERIFY(document.snapshot().documents.at(0).sketchSurface->reading);
    document.undoStack()->undo();
    QVERIFY(!document.snapshot().documents.at(0).sketchSurface->reading);
    document.undoStack()->redo();
    document.startAnew();
    QVERIFY(!document.snapshot().documents.at(0).sketchSurface->reading);
}

QTEST_MAIN(StoredReadingTest)
#include "stored_reading_test.moc"
