// The fixtures of links: a painting on a sketch's surface, and a painting that stands in a filmed scene. To
// make missing ones: DUCTUS_WRITE_FIXTURES=1 test_format_link_fixture. Existing files are never overwritten.
#include "base/sha256.h"
#include "doodling/canvas/edit_scene.h"
#include "doodling/storage/doodle_content.h"
#include "format/fixture_file.h"
#include "painting/edit/element_edits.h"
#include "painting/edit/layer_edits.h"
#include "painting/edit/look_edits.h"
#include "project/project_reader.h"

#include <QtTest>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

const fs::path surfaceV1 = fs::path(DUCTUS_SOURCE_DIR) / "tests/format/v1/painting_link.ductus";
const fs::path propV1 = fs::path(DUCTUS_SOURCE_DIR) / "tests/format/v1/doodle_prop.ductus";
constexpr char surfaceDigestV1[] = "1266fdd5ccb951776e55693a80832715715e12cce66820259d8b1d50c871695f";
constexpr char propDigestV1[] = "a3fe3b3f48e7925f3c09bcb6e0f5ea8d11fa2a5ba93171a21637bac2f88d9636";

const Uuid sketchId = *Uuid::parse("12121212-3434-4565-8787-909090909090");
const Uuid paintingId = *Uuid::parse("a1a1a1a1-b2b2-4c3c-8d4d-e5e5e5e5e5e5");

DocumentLink surfaceLink()
{
    return {"../sketches/h\xc3\xbctte.ductus", sketchId, "H\xc3\xbctte", std::string(64, 'b')};
}

Painting paintingV1()
{
    MeshShape mesh;
    mesh.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1.0 / 3.0, 0.25}};
    mesh.mesh.triangles = {{0, 1, 2}};
    mesh.vertexColours.assign(3, Eigen::Vector3f(0.5f, 0.25f, 0.125f));
    mesh.link = surfaceLink();
    const AddedStack stack = *addStack({}, "hut");
    const Painting painting =
        addElements(stack.painting, stack.substrate, {std::make_shared<const ElementShape>(std::move(mesh))})
            ->painting;
    return addLook(painting, "night").painting;
}

std::shared_ptr<const PaintingContent> contentV1()
{
    return std::make_shared<const PaintingContent>(paintingV1(), UnknownPaintingMembers());
}

Project withDocument(const Uuid &id, const std::string &name, std::shared_ptr<const DocumentContent> content)
{
    Project project;
    project.id = *Uuid::parse("01234567-89ab-4cde-8f01-23456789abcd");
    project.documents.push_back(newDocument(id, name, std::move(content)));
    return project;
}

Project projectWithProp()
{
    Prop prop;
    prop.painting = contentV1();
    prop.link = {"paintings/hut.ductus", paintingId, "hut", std::string(64, 'c')};
    prop.look = "night";
    prop.placement.rotation = Eigen::Quaterniond(0, 1, 0, 0);
    prop.placement.scale = 0.75;
    prop.placement.translation = {0.125, 0.5, -0.25};
    prop.framesPerSecond = 25.0;
    Canvas canvas;
    canvas.name = "hut";
    canvas.keyframes.positions = {{1, Vec2(10.5, 20.25), std::nullopt, false}};
    canvas.prop = std::make_shared<const Prop>(std::move(prop));
    Shot shot;
    shot.width = shot.clipWidth = 64;
    shot.height = shot.clipHeight = 36;
    ShotCamera camera;
    camera.focal = 60.0;
    camera.centre = Vec2(32.0, 18.0);
    shot.cameras.assign(3, camera);
    return withDocument(*Uuid::parse("fefefefe-dcdc-4aba-8989-767676767676"), "film",
                        std::make_shared<const DoodleContent>(
                            ClipReference{"a.mp4", 3, 64, 36, 25.0}, std::make_shared<const Shot>(shot),
                            UnknownMembers(), std::make_shared<const DoodleScene>(*withCanvas({}, canvas))));
}

Result<Project> opened(const fs::path &path)
{
    ProjectReadOptions options;
    options.kinds = {paintingKind(), doodleKind()};
    return openProject(path, options);
}

} // namespace

class LinkFixtureTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void aLinkedSurfaceOpensWithAllValues();
    void aPropOpensWithAllValues();
    void theyAreKeptUnchanged();
    void theyAreValid();
    void aPaintingWithoutAPlaceIsRefused();
};

void LinkFixtureTest::initTestCase()
{
    writeFixtureIfAsked(surfaceV1, withDocument(paintingId, "hut", contentV1()));
    writeFixtureIfAsked(propV1, projectWithProp());
}

void LinkFixtureTest::aLinkedSurfaceOpensWithAllValues()
{
    const Result<Project> project = opened(surfaceV1);
    QVERIFY2(project.ok(), project ? "" : project.error().message().c_str());
    const Painting &painting = (*paintingOf(project->documents[0]))->painting();
    const auto &mesh = std::get<MeshShape>(*painting.stacks[0].substrate->drawings[0].elements[0].shape);
    QVERIFY(mesh.link == surfaceLink());
    QCOMPARE(mesh.mesh.vertices[2].y(), 1.0 / 3.0);
}

void LinkFixtureTest::aPropOpensWithAllValues()
{
    const Result<Project> project = opened(propV1);
    QVERIFY2(project.ok(), project ? "" : project.error().message().c_str());
    const auto content = doodleOf(*project);
    QVERIFY2(content.ok(), content ? "" : content.error().message().c_str());
    const Canvas &canvas = (*content)->scene()->canvases[0];
    QVERIFY(canvas.prop);
    QVERIFY(canvas.prop->link ==
            DocumentLink({"paintings/hut.ductus", paintingId, "hut", std::string(64, 'c')}));
    QCOMPARE(canvas.prop->look, std::string("night"));
    QCOMPARE(canvas.prop->placement.scale, 0.75);
    QCOMPARE(canvas.prop->placement.translation, Vec3(0.125, 0.5, -0.25));
    QCOMPARE(canvas.prop->placement.rotation.x(), 1.0);
    QCOMPARE(canvas.prop->framesPerSecond, 25.0);
    const Painting &painting = canvas.prop->painting->painting();
    QVERIFY(lookNamed(painting, "night"));
    const auto &mesh = std::get<MeshShape>(*painting.stacks[0].substrate->drawings[0].elements[0].shape);
    QVERIFY(mesh.link == surfaceLink());
}

void LinkFixtureTest::theyAreKeptUnchanged()
{
    QCOMPARE(sha256Hex(fixtureBytes(surfaceV1)), std::string(surfaceDigestV1));
    QCOMPARE(sha256Hex(fixtureBytes(propV1)), std::string(propDigestV1));
}

void LinkFixtureTest::theyAreValid()
{
    verifyFixtureIsValid(surfaceV1);
    verifyFixtureIsValid(propV1);
}

void LinkFixtureTest::aPaintingWithoutAPlaceIsRefused()
{
    Project project = projectWithProp();
    const auto content = *doodleOf(project);
    DoodleScene scene = *content->scene();
    Prop prop = *scene.canvases[0].prop;
    prop.placement.mirrored = true;
    scene.canvases[0].prop = std::make_shared<const Prop>(prop);
    project.documents[0].content = std::make_shared<const DoodleContent>(
        content->clip(), content->shot(), content->unknown(), std::make_shared<const DoodleScene>(scene));
    QVERIFY(!serializedProject(project).ok());
}

QTEST_APPLESS_MAIN(LinkFixtureTest)
#include "link_fixture_test.moc"
