// A painting on a sketch's surface: it keeps the link, sees that the surface changed, and takes the new one
// while everything painted stays.
#include "painting/link/surface_link.h"

#include "painting/action/action_log.h"
#include "painting/edit/element_edits.h"
#include "painting/edit/layer_edits.h"
#include "painting/storage/painting_content.h"
#include "painting/testing/sample_painting.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "project/schema_check.h"
#include "project/testing/sample_project.h"

#include <QtTest>

using namespace ductus;

namespace {

// A painting whose second stack stands on the first sketch of \a sketches, twice, with a stroke above.
Painting paintingOn(const Project &sketches, const std::string &file)
{
    const AddedStack stack = *addStack(samplePainting(1), "surface");
    const auto surface = std::make_shared<const ElementShape>(linkedSurface(sketches.documents[0], file));
    Painting painting = addElements(stack.painting, stack.substrate, {surface})->painting;
    const ElementId first = painting.stacks.back().substrate->drawings[0].elements[0].id;
    painting = duplicateElements(painting, {first}, stack.substrate)->painting;
    const AddedLayer layer = *addAppearanceLayer(painting, stack.stack, "shade");
    Random random(1);
    return addElements(layer.painting, layer.layer, {sampleStroke(random, 5, StrokeSection::Round)})
        ->painting;
}

Project changed(Project project)
{
    SketchSurfaceDocument document = *project.documents[0].sketchSurface;
    for (Vec3 &vertex : document.surface->mesh.vertices)
        vertex *= 1.5;
    project.documents[0].sketchSurface = std::make_shared<const SketchSurfaceDocument>(document);
    return project;
}

Painting updated(const Painting &painting, const SurfaceLink &link)
{
    return *replaceShapes(painting, link.outdated, link.updates);
}

} // namespace

class SurfaceLinkTest : public QObject
{
    Q_OBJECT
private slots:
    void theLinkGoesThroughTheProjectFile();
    void theLinkGoesThroughTheActionLog();
    void nothingIsNewerUntilTheSurfaceChanges();
    void anUpdateKeepsAllThatWasPainted();
    void coloursAreCarriedOver();
    void aLostSketchIsAProblemAndNoUpdate();
    void aLockedLayerRefusesTheUpdate();
};

void SurfaceLinkTest::theLinkGoesThroughTheProjectFile()
{
    const Project sketches = sampleProject(1);
    const Painting before = paintingOn(sketches, "sketches/hut.ductus");
    Project project;
    project.id = *Uuid::parse("11111111-2222-4333-8444-555555555555");
    project.documents.push_back(
        newDocument(*Uuid::parse("aaaaaaaa-bbbb-4ccc-8ddd-eeeeeeeeeeee"), "p",
                    std::make_shared<const PaintingContent>(before, UnknownPaintingMembers())));
    const Result<SerializedProject> written = serializedProject(project);
    QVERIFY2(written.ok(), written ? "" : written.error().message().c_str());
    const auto lines = projectSchemaViolations(written->bytes, "p");
    QVERIFY2(lines.ok() && lines->empty(), lines && !lines->empty() ? lines->front().c_str() : "");
    ProjectReadOptions options;
    options.kinds = {paintingKind()};
    const Result<Project> again = parseProject(written->bytes, "p.ductus", options);
    QVERIFY2(again.ok(), again ? "" : again.error().message().c_str());
    const Painting &after = (*paintingOf(again->documents[0]))->painting();
    QCOMPARE(paintingFingerprint(after), paintingFingerprint(before));
    const auto &element = after.stacks.back().substrate->drawings[0].elements[1];
    QVERIFY(std::get<MeshShape>(*element.shape).link ==
            DocumentLink({"sketches/hut.ductus", sketches.documents[0].id, sketches.documents[0].name,
                          linkedSurface(sketches.documents[0], "").link->digest}));
}

void SurfaceLinkTest::theLinkGoesThroughTheActionLog()
{
    const Project sketches = sampleProject(1);
    const Painting painting = paintingOn(sketches, "");
    const Element &element = painting.stacks.back().substrate->drawings[0].elements[0];
    const std::string line = logLine({"", act::ReplaceShape{{element.id}, {element.shape}}, {}});
    const auto log = parsedLog(line + "\n", "log");
    QVERIFY2(log.ok(), log ? "" : log.error().message().c_str());
    const auto &action = std::get<act::ReplaceShape>(std::get<PaintingAction>(log->front().event));
    QVERIFY(std::get<MeshShape>(*action.strokes[0]).link == std::get<MeshShape>(*element.shape).link);
    QCOMPARE(logLine(log->front()), line);
}

void SurfaceLinkTest::nothingIsNewerUntilTheSurfaceChanges()
{
    const Project sketches = sampleProject(1), later = changed(sketches);
    const Painting painting = paintingOn(sketches, "");
    LinkSources same(sketches, {}, {}), newer(later, {}, {});
    const std::vector<SurfaceLink> before = surfaceLinks(painting, same),
                                   after = surfaceLinks(painting, newer);
    QCOMPARE(before.size(), std::size_t(1));
    QVERIFY(!before[0].isOutdated() && !before[0].problem);
    QCOMPARE(before[0].elements.size(), std::size_t(2));
    QVERIFY(after[0].isOutdated());
    QCOMPARE(after[0].outdated, before[0].elements);
    QVERIFY(after[0].updates[0] == after[0].updates[1]); // duplicates go on sharing
    // Once taken, nothing is newer.
    QVERIFY(!surfaceLinks(updated(painting, after[0]), newer)[0].isOutdated());
}

void SurfaceLinkTest::anUpdateKeepsAllThatWasPainted()
{
    const Project sketches = sampleProject(1), later = changed(sketches);
    const Painting painting = paintingOn(sketches, "");
    LinkSources sources(later, {}, {});
    const Painting after = updated(painting, surfaceLinks(painting, sources)[0]);
    const auto &mesh = std::get<MeshShape>(*after.stacks.back().substrate->drawings[0].elements[0].shape);
    QCOMPARE(mesh.mesh.vertices[2], later.documents[0].sketchSurface->surface->mesh.vertices[2]);
    // With the old shape back, nothing else is different.
    const Element &old = painting.stacks.back().substrate->drawings[0].elements[0];
    const Painting back = *replaceShapes(
        after, {old.id, painting.stacks.back().substrate->drawings[0].elements[1].id}, {old.shape});
    QCOMPARE(paintingFingerprint(back), paintingFingerprint(painting));
    QVERIFY(paintingFingerprint(after) != paintingFingerprint(painting));
}

void SurfaceLinkTest::coloursAreCarriedOver()
{
    MeshShape old;
    old.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    old.mesh.triangles = {{0, 1, 2}};
    old.vertexColours.assign(3, Eigen::Vector3f(0.2f, 0.4f, 0.6f));
    TriangleMesh mesh;
    mesh.vertices = {{0.9, 0.1, 0}, {0, 2, 0}, {0.1, 0.1, 0.3}, {3, 0, 0}};
    for (const Eigen::Vector3f &colour : coloursCarriedOver(old, mesh))
        QCOMPARE(colour, old.vertexColours[0]);
    old.vertexColours[1] = {1, 0, 0};
    old.vertexColours[2] = {0, 1, 0};
    const std::vector<Eigen::Vector3f> carried = coloursCarriedOver(old, mesh);
    QCOMPARE(carried[0], old.vertexColours[1]);
    QCOMPARE(carried[1], old.vertexColours[2]);
    QCOMPARE(carried[2], old.vertexColours[0]);
    QCOMPARE(carried[3], old.vertexColours[1]);
}

void SurfaceLinkTest::aLostSketchIsAProblemAndNoUpdate()
{
    const Project sketches = sampleProject(1);
    const Painting painting = paintingOn(sketches, "/nowhere/at/all.ductus");
    const Project own;
    LinkSources sources(own, {}, {});
    const std::vector<SurfaceLink> links = surfaceLinks(painting, sources);
    QVERIFY(links[0].problem && links[0].problem->code == ErrorCode::FileNotFound);
    QVERIFY(!links[0].isOutdated());
    // A sketch that lost its surface is another thing than one that changed it.
    Project bare = sketches;
    SketchSurfaceDocument document = *bare.documents[0].sketchSurface;
    document.surface.reset();
    bare.documents[0].sketchSurface = std::make_shared<const SketchSurfaceDocument>(document);
    LinkSources without(bare, {}, {});
    QCOMPARE(surfaceLinks(paintingOn(sketches, ""), without)[0].problem->code, ErrorCode::TooLittleData);
}

void SurfaceLinkTest::aLockedLayerRefusesTheUpdate()
{
    const Project sketches = sampleProject(1), later = changed(sketches);
    Painting painting = paintingOn(sketches, "");
    painting.stacks.back().substrate->locked = true;
    LinkSources sources(later, {}, {});
    const SurfaceLink link = surfaceLinks(painting, sources)[0];
    const Result<Painting> refused = replaceShapes(painting, link.outdated, link.updates);
    QVERIFY(!refused && refused.error().code == ErrorCode::Locked);
}

QTEST_APPLESS_MAIN(SurfaceLinkTest)
#include "surface_link_test.moc"
