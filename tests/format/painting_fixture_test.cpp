// One painting per released version of the format, kept for ever: whatever changes, it opens with these
// values. To make a missing one: DUCTUS_WRITE_FIXTURES=1 test_format_painting_fixture. Existing files are
// never overwritten.
#include "base/sha256.h"
#include "format/fixture_file.h"
#include "painting/storage/painting_content.h"
#include "project/project_reader.h"
#include "project/project_writer.h"

#include <QtTest>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

const fs::path fixtureV1 = fs::path(DUCTUS_SOURCE_DIR) / "tests/format/v1/painting.ductus";

// Numbers written out, so that no helper that changes later can change what is expected.
Painting paintingV1()
{
    Painting painting;
    painting.nextId = 40;
    painting.metresPerUnit = 0.01;
    painting.blendSpace = BlendSpace::Linear;
    painting.background = {0.25f, 0.5f, 0.75f};
    painting.loopSeconds = 6.5;
    StrokeShape stroke;
    stroke.section = StrokeSection::Ellipse;
    stroke.points = {{{0.1f, -0.2f, 0.3f}, {0, 1, 0}, 0.05f, {1, 0.5f, 0.1f}, 0.75f},
                     {{1, 2, 3}, {0, 0, 1}, 0.f, {0, 0, 0}, 1}};
    const auto shape = std::make_shared<const ElementShape>(stroke);
    MeshShape mesh;
    mesh.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 1.0 / 3.0}};
    mesh.mesh.triangles = {{0, 1, 2}};
    mesh.vertexColours = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Placement placement;
    placement.rotation = Eigen::Quaterniond(0.6, 0, 0.8, 0);
    placement.scale = 2.5;
    placement.mirrored = true;
    placement.translation = {1, -2, 0.1};

    Stack stack{StackId{1}, "\xc3\x89t\xc3\xa9", Layer{}, {}};
    stack.substrate->id = LayerId{2};
    stack.substrate->name = "shape";
    stack.substrate->drawings[0].elements = {
        {ElementId{3}, {}, shape}, {ElementId{4}, placement, std::make_shared<const ElementShape>(mesh)}};
    Layer shade;
    shade.id = LayerId{5};
    shade.name = "shade";
    shade.locked = true;
    shade.tolerance = 0.125;
    shade.toleranceMode = ToleranceMode::View;
    shade.properties.opacity = 0.3;
    shade.properties.blendMode = BlendMode::SoftLight;
    shade.properties.colour = Eigen::Vector3f(0.1f, 0.2f, 0.7f);
    shade.properties.masks = {
        {true, true,
         GradientMask{GradientMask::Shape::Spherical, {0, 1, 2}, {3, 4, 5}, 0.25, 0.75, MaskEasing::Smooth}},
        {false, false, NoiseMask{0.5, 18446744073709551615ull, 0.4, 0.3, 0.2, 0.9}},
        {true, false,
         TextureMask{placement, 2, 1, 3,
                     std::make_shared<const std::vector<std::uint8_t>>(
                         std::vector<std::uint8_t>{0, 1, 127, 128, 254, 255})}},
        {true, true, StrokeMask{LayerId{2}, false}}};
    shade.drawings.resize(2);
    shade.drawings[1].elements = {{ElementId{6}, placement, shape}};
    shade.frames = {12.5, 3, {0, 1, 1, 0}};
    shade.motion = {{-1, placement, KeyInterpolation::Hold}, {2.5, {}, KeyInterpolation::Smooth}};
    stack.appearance = {shade};
    painting.stacks = {stack};
    Layer light;
    light.id = LayerId{7};
    light.name = "light";
    painting.sceneStack.appearance = {light};
    LayerProperties dark;
    dark.visible = false;
    dark.opacity = 0.9;
    painting.looks = {{LookId{8}, "night", {{LayerId{7}, dark}}}};
    painting.motionGroups = {{MotionGroupId{9},
                              "plane",
                              {ElementId{3}, ElementId{6}},
                              {{0, placement, KeyInterpolation::Linear}}}};
    painting.camera.keys = {
        {1.5, {0, 1, 5}, Eigen::Quaterniond(0.8, 0.6, 0, 0), 33.5, KeyInterpolation::Smooth}};
    Image image(2, 1, {10, 20, 30, 40});
    painting.pictures = {
        {PictureId{10}, "target", false, 0.5, placement, std::make_shared<const Image>(image)}};
    return painting;
}

Project projectV1()
{
    Project project;
    project.id = *Uuid::parse("11111111-2222-4333-8444-666666666666");
    project.generator = "Ductus 0.1.0";
    project.documents.push_back(
        newDocument(*Uuid::parse("aaaaaaaa-bbbb-4ccc-8ddd-ffffffffffff"), "scene",
                    std::make_shared<const PaintingContent>(
                        paintingV1(), UnknownPaintingMembers{{"layer:5", {{"future", "{\"x\":1.50}"}}}})));
    return project;
}

Result<Project> opened()
{
    ProjectReadOptions options;
    options.kinds = {paintingKind()};
    return openProject(fixtureV1, options);
}

} // namespace

class PaintingFixtureTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void version1OpensWithAllValues();
    void version1IsKeptUnchanged();
    void version1IsValid();
};

void PaintingFixtureTest::initTestCase()
{
    writeFixtureIfAsked(fixtureV1, projectV1());
}

void PaintingFixtureTest::version1OpensWithAllValues()
{
    const Result<Project> project = opened();
    QVERIFY2(project.ok(), project.ok() ? "" : project.error().message().c_str());
    QVERIFY(project->warnings.empty() && !project->readOnly);
    const auto content = paintingOf(project->documents[0]);
    QVERIFY(content.ok());
    // Equal texts with buffers named by their content mean equal paintings, down to the last bit.
    BufferPacker found, expected;
    QCOMPARE(jsonText((*content)->toJson(project->documents[0].id, found)),
             jsonText((*paintingOf(projectV1().documents[0]))->toJson(project->documents[0].id, expected)));
    const Painting &painting = (*content)->painting();
    const Layer &shade = painting.stacks[0].appearance[0];
    QCOMPARE(shade.properties.blendMode, BlendMode::SoftLight);
    QCOMPARE(shade.drawings[1].elements[0].placement.scale, 2.5);
    QCOMPARE(shade.drawings[1].elements[0].shape,
             painting.stacks[0].substrate->drawings[0].elements[0].shape);
    QCOMPARE((*content)->unknown().at("layer:5").front().second, std::string("{\"x\":1.50}"));
}

void PaintingFixtureTest::version1IsKeptUnchanged()
{
    QCOMPARE(sha256Hex(fixtureBytes(fixtureV1)),
             std::string("8e8dbfd7110266fed31dd9e9653862047dba8ae2d9d977ea631a2853d252d8e1"));
}

void PaintingFixtureTest::version1IsValid()
{
    verifyFixtureIsValid(fixtureV1);
}

QTEST_APPLESS_MAIN(PaintingFixtureTest)
#include "painting_fixture_test.moc"
