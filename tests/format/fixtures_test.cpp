// One file per released version of the format, kept for ever: whatever changes, these open with these values.
// To make a missing one: DUCTUS_WRITE_FIXTURES=1 test_format_fixtures. Existing files are never overwritten.
#include "base/sha256.h"
#include "format/fixture_file.h"
#include "project/container/container_reader.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "project/testing/sample_project.h"

#include <QtTest>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

const fs::path fixtureV1 = fs::path(DUCTUS_SOURCE_DIR) / "tests/format/v1/sketch_surface.ductus";

// Numbers written out, so that no helper that changes later can change what is expected.
SketchSurfaceDocument documentV1()
{
    SketchSurfaceDocument document;
    document.strokes.metresPerUnit = 0.01;
    document.strokes.upAxis = UpAxis::Z;
    Stroke first;
    first.id = StrokeId{0};
    first.points = {
        {0.1, -0.2, 0.30000000000000004}, {1e-300, -0.0, 12345.678901234567}, {1.0 / 3.0, 2.0, -3.0}};
    first.pressure = {0.0, 0.5, 1.0};
    first.timeSeconds = {10.0, 10.011, 10.025};
    Stroke second;
    second.id = StrokeId{7};
    second.role = StrokeRole::Boundary;
    second.points = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
    document.strokes.strokes = {first, second};
    for (StrokeRole role : {StrokeRole::Ignored, StrokeRole::Inner, StrokeRole::Skeletal}) {
        second.id.value += 1;
        second.role = role;
        document.strokes.strokes.push_back(second);
    }
    document.settings.epsilon = 0.0125;
    document.settings.simplicity = 0.02;
    document.settings.smoothness = 11.5;
    document.settings.runs = 3;
    document.settings.seed = 18446744073709551615ull;
    document.settings.symmetryPlane = StoredSymmetryPlane{{0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}, {}};
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    document.proxy = StoredProxy{mesh, {}};
    mesh.vertices[3] = {0.25, 0.25, 0.75};
    StoredSurface surface;
    surface.mesh = mesh;
    surface.triangleRegions = {0, 1, 1, 2};
    surface.featureLines = {{0, 1, 2}, {3, 0}};
    surface.models = {
        {1, {0.0, 0.0, 0.0, 1.0}, {}}, {2, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, {}}, {0, {-1.5}, {}}};
    document.surface = surface;
    return document;
}

Project projectV1()
{
    Project project;
    project.id = *Uuid::parse("11111111-2222-4333-8444-555555555555");
    project.generator = "Ductus 0.1.0";
    project.documents.push_back(newSketchSurface(*Uuid::parse("aaaaaaaa-bbbb-4ccc-8ddd-eeeeeeeeeeee"),
                                                 "T\xc3\xa9tra\xc3\xa8"
                                                 "dre",
                                                 documentV1()));
    project.unknown = {{"links", "[ ]"}, {"fromTheFuture", "{\"x\":1.50}"}};
    project.keptEntries["future/notes.txt"] = packedEntry("future/notes.txt", asBytes("kept as it is\n"));
    return project;
}

// Made when a chosen reading began to be stored.
const fs::path fixtureReading = fs::path(DUCTUS_SOURCE_DIR) / "tests/format/v1/sketch_surface_reading.ductus";

Project projectWithReading()
{
    Project project = projectV1();
    SketchSurfaceDocument document = documentV1();
    StoredReading reading;
    reading.points = {{0.5, 0.25, -0.125}, {1.0 / 3.0, 2.0, -0.0}, {7.0, 8.0, 9.0}};
    reading.labels = {1, 0, 1};
    reading.models = {{1, {0.1, 0.2, 0.30000000000000004}, {1.0, 0.0, -0.5, 2.0}, {}},
                      {2, {0.0, 0.0, 0.0}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 1.0 / 3.0}, {}}};
    document.reading = reading;
    project.documents.clear();
    project.documents.push_back(newSketchSurface(*Uuid::parse("aaaaaaaa-bbbb-4ccc-8ddd-eeeeeeeeeeef"),
                                                 "Another reading", std::move(document)));
    return project;
}

} // namespace

class FixturesTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void version1OpensWithAllValues();
    void version1IsKeptUnchanged();
    void version1IsValid();
    void version1SavesWithoutLoss();
    void aChosenReadingOpensWithAllValues();
};

void FixturesTest::initTestCase()
{
    writeFixtureIfAsked(fixtureV1, projectV1());
    writeFixtureIfAsked(fixtureReading, projectWithReading());
}

void FixturesTest::version1OpensWithAllValues()
{
    const Result<Project> project = openProject(fixtureV1);
    QVERIFY2(project.ok(), project.ok() ? "" : project.error().message().c_str());
    QCOMPARE(difference(projectV1(), *project), std::string());
    QVERIFY(project->warnings.empty() && !project->readOnly);
    QCOMPARE(project->keptEntries.size(), std::size_t(1));
    const Stroke &stroke = project->documents[0].sketchSurface->strokes.strokes[0];
    QCOMPARE(stroke.points[1].z(), 12345.678901234567);
    QCOMPARE(stroke.timeSeconds[2], 10.025);
    QCOMPARE(project->documents[0].sketchSurface->surface->featureLines[1][0], 3);
}

void FixturesTest::version1IsKeptUnchanged()
{
    QCOMPARE(sha256Hex(fixtureBytes(fixtureV1)),
             std::string("0cd22709da9f3d2eaf722e04a8922d5509587142c202b6c2b330dd794a218d51"));
}

void FixturesTest::version1IsValid()
{
    verifyFixtureIsValid(fixtureV1);
}

void FixturesTest::version1SavesWithoutLoss()
{
    Project project = *openProject(fixtureV1);
    project.documents[0].name = "renamed";
    const Result<Project> again = parseProject(serializedProject(project)->bytes, "again");
    QCOMPARE(difference(project, *again), std::string());
    const Result<Bytes> notes = unpacked(again->keptEntries.at("future/notes.txt"), "notes");
    QVERIFY(std::ranges::equal(*notes, asBytes("kept as it is\n")));
}

void FixturesTest::aChosenReadingOpensWithAllValues()
{
    const Result<Project> project = openProject(fixtureReading);
    QVERIFY2(project.ok(), project.ok() ? "" : project.error().message().c_str());
    QCOMPARE(difference(projectWithReading(), *project), std::string());
    QVERIFY(project->warnings.empty() && !project->readOnly);
    const StoredReading &reading = *project->documents[0].sketchSurface->reading;
    QCOMPARE(reading.labels[2], 1);
    QCOMPARE(reading.models[1].coefficients[9], 1.0 / 3.0);
    verifyFixtureIsValid(fixtureReading);
    QCOMPARE(sha256Hex(fixtureBytes(fixtureReading)),
             std::string("bd7cf2ff57a3ff3a7863e965ec3df62d6aff44871852f451cced606e8a00126c"));
}

QTEST_APPLESS_MAIN(FixturesTest)
#include "fixtures_test.moc"
