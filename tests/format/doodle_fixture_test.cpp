// One doodle per released version of the format, kept for ever: whatever changes, it opens with these values.
// To make a missing one: DUCTUS_WRITE_FIXTURES=1 test_format_doodle_fixture. Existing files are never
// overwritten.
#include "base/sha256.h"
#include "doodling/storage/doodle_content.h"
#include "format/fixture_file.h"
#include "project/project_reader.h"
#include "project/project_writer.h"

#include <QtTest>

using namespace ductus;
namespace fs = std::filesystem;

namespace {

const fs::path fixtureV1 = fs::path(DUCTUS_SOURCE_DIR) / "tests/format/v1/doodle.ductus";
constexpr char digestV1[] = "0d1fc3098913ef305549637ecc9b03259dd3aac4b0cbc771e8651f220794e9ef";

// Numbers written out, so that no helper that changes later can change what is expected.
std::shared_ptr<const Shot> shotV1()
{
    auto shot = std::make_shared<Shot>();
    shot->width = 854;
    shot->height = 480;
    shot->clipWidth = 1708;
    shot->clipHeight = 960;
    shot->knowledge = CameraKnowledge::SolvedCameras;
    shot->sceneDepth = 3.75;
    for (int t = 0; t < 3; ++t) {
        ShotCamera camera;
        camera.focal = 700.5 + 0.25 * t;
        camera.centre = Vec2(427.0, 240.0);
        camera.worldFromCamera.linear() = Eigen::Quaterniond(0.8, 0.0, 0.6, 0.0).toRotationMatrix();
        camera.worldFromCamera.translation() = Vec3(0.5 * t, -0.125, 1.0 / 3.0);
        shot->cameras.push_back(camera);
    }
    return shot;
}

MarkPointer mark(DoodleMark one)
{
    return std::make_shared<const DoodleMark>(std::move(one));
}

std::shared_ptr<const DoodleScene> sceneV1()
{
    InkStroke ink;
    ink.line.points = {{0.1, 0.2, 0.0}, {1.0 / 3.0, 0.25, 0.0}, {0.5, -0.1, 0.0}};
    ink.line.pressure = {0.1, 0.9, 0.5};
    ink.line.timeSeconds = {0.0, 0.016, 0.04};
    ink.colour = {1, 2, 3, 128};
    ink.width = 0.07;
    Image picture(3, 2, {9, 8, 7, 255});
    picture.set(1, 1, {50, 60, 70, 80});

    Canvas face;
    face.id = CanvasId{4};
    face.name = "Gesicht \xe9\xa1\x94";
    face.motion = CanvasMotion::Dynamic;
    face.turning = CanvasTurning::AlongPath;
    face.size = Vec2(1.5, 0.75);
    face.opacity = 0.5;
    face.shownFrom = 1;
    face.shownUntil = 2;
    face.keyframes.positions = {{0, Vec2(10.25, 20.0), std::nullopt, true},
                                {2, Vec2(30.0, 11.0), 3.5, false}};
    face.keyframes.depths = {{1, 4.25}};
    face.keyframes.turns = {{1, Eigen::Quaterniond(0.6, 0.8, 0.0, 0.0), true}};
    face.keyframes.scales = {{0, 1.0}, {2, 2.0}};
    face.occlusion = {true, -0.01, 0.06, {{2, {{1.0, 2.0}, {3.5, 4.0}}, 6.5, false, 3}}};
    face.doodle.frames = {
        {{mark(ink), mark(FilledShape{{{0, 0}, {1, 0}, {0.5, 1.0 / 7.0}}, {5, 6, 7, 8}}),
          mark(TextMark{
              "gr\xc3\xbc\xc3\x9f\ndich", {0.1, -0.2}, 0.3, 0.4, false, {1, 1, 1, 255}, {2, 2, 2, 0}})},
         4},
        {{mark(ArrowMark{{{0, 0}, {0.3, 0.1}}, 0.05, {9, 9, 9, 255}}),
          mark(StickerMark{"heart", {0.2, 0.3}, 0.5, -0.1, {200, 0, 0, 255}}),
          mark(PictureMark{std::make_shared<const Image>(picture), {0, 0}, {0.3, 0.2}, 0.25})},
         1}};
    face.doodle.repeat = DoodleRepeat::PingPong;
    face.doodle.offset = -3;

    Canvas words;
    words.id = CanvasId{2};
    words.name = "words";
    words.isVisible = false;
    words.keyframes.positions = {{1, Vec2(1.0, 2.0), std::nullopt, false}};
    words.occlusion.isOn = false;

    DoodleScene scene;
    scene.canvases = {face, words};
    return std::make_shared<const DoodleScene>(std::move(scene));
}

ClipReference clipV1()
{
    ClipReference clip;
    clip.path = "films/B\xc3\xa4r.mp4";
    clip.frameCount = 3;
    clip.width = 1708;
    clip.height = 960;
    clip.framesPerSecond = 23.976;
    return clip;
}

Project projectV1()
{
    Project project;
    project.id = *Uuid::parse("11111111-2222-4333-8444-777777777777");
    project.generator = "Ductus 0.1.0";
    project.documents.push_back(
        newDocument(*Uuid::parse("aaaaaaaa-bbbb-4ccc-8ddd-999999999999"), "lesson",
                    std::make_shared<const DoodleContent>(clipV1(), shotV1(), UnknownMembers(), sceneV1())));
    return project;
}

// Equal texts with buffers named by their content mean equal clips and scenes, down to the last bit.
std::string textOf(const ClipReference &clip, const std::shared_ptr<const DoodleScene> &scene)
{
    BufferPacker packer;
    const DoodleContent content(clip, shotV1(), {}, scene);
    return jsonText(content.toJson(*Uuid::parse("aaaaaaaa-bbbb-4ccc-8ddd-999999999999"), packer));
}

} // namespace

class DoodleFixtureTest : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void version1OpensWithAllValues();
    void version1IsKeptUnchanged();
    void version1IsValid();
};

void DoodleFixtureTest::initTestCase()
{
    writeFixtureIfAsked(fixtureV1, projectV1());
}

void DoodleFixtureTest::version1OpensWithAllValues()
{
    ProjectReadOptions options;
    options.kinds = {doodleKind()};
    const Result<Project> project = openProject(fixtureV1, options);
    QVERIFY2(project.ok(), project.ok() ? "" : project.error().message().c_str());
    QVERIFY(project->warnings.empty() && !project->readOnly);
    const auto content = doodleOf(*project);
    QVERIFY2(content.ok(), content.ok() ? "" : content.error().message().c_str());
    QCOMPARE(textOf((*content)->clip(), (*content)->scene()), textOf(clipV1(), sceneV1()));
    const std::vector<Canvas> &canvases = (*content)->scene()->canvases;
    QCOMPARE(int(canvases.size()), 2);
    QCOMPARE(canvases[0].keyframes.positions[1].depth.value_or(0.0), 3.5);
    QCOMPARE(std::get<TextMark>(*canvases[0].doodle.frames[0].marks[2]).text,
             std::string("gr\xc3\xbc\xc3\x9f\ndich"));
    QCOMPARE(std::get<PictureMark>(*canvases[0].doodle.frames[1].marks[2]).image->at(1, 1),
             Rgba({50, 60, 70, 80}));

    const Shot &shot = *(*content)->shot();
    QCOMPARE(shot.frameCount(), 3);
    QVERIFY(shot.knowledge == CameraKnowledge::SolvedCameras);
    QCOMPARE(QSize(shot.width, shot.height), QSize(854, 480));
    QCOMPARE(shot.sceneDepth, 3.75);
    for (int t = 0; t < 3; ++t) {
        const ShotCamera &camera = shot.cameras[std::size_t(t)], expected = shotV1()->cameras[std::size_t(t)];
        QCOMPARE(camera.focal, expected.focal);
        QVERIFY(camera.worldFromCamera.isApprox(expected.worldFromCamera, 1e-12));
    }
}

void DoodleFixtureTest::version1IsKeptUnchanged()
{
    QCOMPARE(sha256Hex(fixtureBytes(fixtureV1)), std::string(digestV1));
}

void DoodleFixtureTest::version1IsValid()
{
    verifyFixtureIsValid(fixtureV1);
}

QTEST_APPLESS_MAIN(DoodleFixtureTest)
#include "doodle_fixture_test.moc"
