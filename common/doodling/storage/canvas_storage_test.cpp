#include "doodling/storage/canvas_storage.h"

#include "base/random.h"
#include "doodling/canvas/edit_doodle.h"
#include "doodling/canvas/edit_scene.h"
#include "doodling/storage/doodle_content.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "project/schema_check.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int frames = 6;

Shot plainShot()
{
    Shot shot;
    shot.width = shot.clipWidth = 64;
    shot.height = shot.clipHeight = 36;
    ShotCamera camera;
    camera.focal = 60.0;
    camera.centre = Vec2(32.0, 18.0);
    const FlowField flow{1, 1, 64.0, {Eigen::Vector2f::Zero()}, {1.0f}};
    shot.cameras.assign(frames, camera);
    shot.forward.assign(frames - 1, flow);
    shot.backward.assign(frames - 1, flow);
    return shot;
}

Doodle drawn()
{
    InkStroke ink;
    ink.line.points = {{0.1, 0.2, 0.0}, {1.0 / 3.0, 0.25, 0.0}, {0.5, -0.1, 0.0}};
    ink.line.pressure = {0.1, 0.9, 0.5};
    ink.line.timeSeconds = {0.0, 0.016, 0.04};
    ink.colour = {1, 2, 3, 128};
    ink.width = 0.07;
    Image picture(3, 2, {9, 8, 7, 255});
    picture.set(1, 1, {50, 60, 70, 80});
    Doodle doodle = *withInsertedFrame(Doodle(), 1, 4);
    doodle = *withMark(doodle, 0, ink);
    doodle = *withMark(doodle, 0, FilledShape{{{0, 0}, {1, 0}, {0.5, 1.0 / 7.0}}, {5, 6, 7, 8}});
    doodle = *withMark(doodle, 0,
                       TextMark{"grüß\ndich", {0.1, -0.2}, 0.3, 0.4, false, {1, 1, 1, 255}, {2, 2, 2, 0}});
    doodle = *withMark(doodle, 1, ArrowMark{{{0, 0}, {0.3, 0.1}}, 0.05, {9, 9, 9, 255}});
    doodle = *withMark(doodle, 1, StickerMark{"heart", {0.2, 0.3}, 0.5, -0.1, {200, 0, 0, 255}});
    doodle =
        *withMark(doodle, 1, PictureMark{std::make_shared<const Image>(picture), {0, 0}, {0.3, 0.2}, 0.25});
    doodle.repeat = DoodleRepeat::PingPong;
    doodle.offset = -3;
    return doodle;
}

DoodleScene sceneOfTwo()
{
    Canvas canvas;
    canvas.name = "Gesicht";
    canvas.motion = CanvasMotion::Dynamic;
    canvas.turning = CanvasTurning::AlongPath;
    canvas.size = Vec2(1.5, 0.75);
    canvas.opacity = 0.5;
    canvas.shownFrom = 1;
    canvas.shownUntil = 4;
    canvas.keyframes.positions = {{0, Vec2(10.25, 20.0), std::nullopt, true},
                                  {4, Vec2(30.0, 11.0), 3.5, false}};
    canvas.keyframes.depths = {{2, 4.25}};
    canvas.keyframes.turns = {{1, Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Vec3::UnitY())), true}};
    canvas.keyframes.scales = {{0, 1.0}, {5, 2.0}};
    canvas.occlusion = {true, -0.01, 0.06, {{2, {{1.0, 2.0}, {3.5, 4.0}}, 6.5, false, 3}}};
    canvas.doodle = drawn();
    Canvas plain;
    plain.isVisible = false;
    plain.keyframes.positions = {{5, Vec2(1.0, 2.0), std::nullopt, false}};
    return *withCanvas(*withCanvas({}, canvas), plain);
}

Project projectOf(const DoodleScene &scene)
{
    Random random(1);
    Project project;
    project.id = Uuid::from(random);
    project.documents.push_back(newDocument(
        Uuid::from(random), "clip",
        std::make_shared<const DoodleContent>(ClipReference{"a.mp4", frames, 64, 36, 25.0},
                                              std::make_shared<const Shot>(plainShot()), UnknownMembers(),
                                              std::make_shared<const DoodleScene>(scene))));
    return project;
}

Result<Project> reread(const Bytes &bytes)
{
    ProjectReadOptions options;
    options.kinds = {doodleKind()};
    return parseProject(bytes, "test.ductus", options);
}

} // namespace

class CanvasStorageTest : public QObject
{
    Q_OBJECT
private slots:
    void everythingComesBack();
    void savingWhatWasReadGivesTheSameBytes();
    void theSchemaKnowsAllOfIt();
    void withoutDrawingsThereIsNoScene();
    void whatAReaderWouldRefuseIsNotWritten();
};

void CanvasStorageTest::everythingComesBack()
{
    const Result<SerializedProject> bytes = serializedProject(projectOf(sceneOfTwo()));
    QVERIFY2(bytes.ok(), bytes.ok() ? "" : bytes.error().message().c_str());
    const Result<Project> project = reread(bytes->bytes);
    QVERIFY2(project.ok(), project.ok() ? "" : project.error().message().c_str());
    const auto content = doodleOf(*project);
    QVERIFY2(content.ok(), content.ok() ? "" : content.error().message().c_str());
    const DoodleScene &scene = *(*content)->scene(), made = sceneOfTwo();
    QCOMPARE(int(scene.canvases.size()), 2);
    const Canvas &a = scene.canvases[0], &b = made.canvases[0];
    QCOMPARE(a.id.value, b.id.value);
    QCOMPARE(a.name, b.name);
    QVERIFY(a.motion == b.motion && a.turning == b.turning && a.size == b.size && a.isVisible);
    QCOMPARE(a.opacity, 0.5);
    QCOMPARE(a.shownFrom, 1);
    QCOMPARE(a.shownUntil, 4);
    QCOMPARE(int(a.keyframes.positions.size()), 2);
    QCOMPARE(a.keyframes.positions[0].pixel, Vec2(10.25, 20.0));
    QVERIFY(a.keyframes.positions[0].interpolatesNext && !a.keyframes.positions[0].depth);
    QCOMPARE(a.keyframes.positions[1].depth.value(), 3.5);
    QCOMPARE(a.keyframes.depths[0].depth, 4.25);
    QVERIFY(a.keyframes.turns[0].worldFromCanvas.coeffs() == b.keyframes.turns[0].worldFromCanvas.coeffs());
    QVERIFY(a.keyframes.turns[0].interpolatesNext);
    QCOMPARE(a.keyframes.scales[1].scale, 2.0);
    QCOMPARE(a.occlusion.bias, -0.01);
    QCOMPARE(a.occlusion.touches[0].line[1], Vec2(3.5, 4.0));
    QCOMPARE(a.occlusion.touches[0].reach, 3);
    QVERIFY(!a.occlusion.touches[0].isCanvasInFront);
    QVERIFY(a.doodle.repeat == DoodleRepeat::PingPong);
    QCOMPARE(a.doodle.offset, -3);
    QCOMPARE(int(a.doodle.frames.size()), 2);
    QCOMPARE(a.doodle.frames[1].hold, 4);
    const auto &first = a.doodle.frames[0].marks, &second = a.doodle.frames[1].marks;
    const InkStroke &ink = std::get<InkStroke>(*first[0]);
    QCOMPARE(ink.line.points[1], Vec3(1.0 / 3.0, 0.25, 0.0));
    QCOMPARE(ink.line.pressure[1], 0.9);
    QCOMPARE(ink.line.timeSeconds[2], 0.04);
    QVERIFY(ink.colour == (Rgba{1, 2, 3, 128}));
    QCOMPARE(ink.width, 0.07);
    QCOMPARE(std::get<FilledShape>(*first[1]).outline[2], Vec2(0.5, 1.0 / 7.0));
    const TextMark &text = std::get<TextMark>(*first[2]);
    QCOMPARE(text.text, std::string("grüß\ndich"));
    QVERIFY(!text.isBold && text.edge[3] == 0 && text.turn == 0.4 && text.height == 0.3);
    QCOMPARE(std::get<ArrowMark>(*second[0]).points[1], Vec2(0.3, 0.1));
    QCOMPARE(std::get<StickerMark>(*second[1]).name, std::string("heart"));
    const PictureMark &picture = std::get<PictureMark>(*second[2]);
    QCOMPARE(picture.size, Vec2(0.3, 0.2));
    QVERIFY(picture.image->pixels == std::get<PictureMark>(*b.doodle.frames[1].marks[2]).image->pixels);
    QVERIFY(!scene.canvases[1].isVisible);
}

void CanvasStorageTest::savingWhatWasReadGivesTheSameBytes()
{
    const Result<SerializedProject> once = serializedProject(projectOf(sceneOfTwo()));
    QVERIFY(once.ok());
    const auto content = doodleOf(*reread(once->bytes));
    QVERIFY(content.ok());
    const Result<SerializedProject> twice = serializedProject(projectOf(*(*content)->scene()));
    QVERIFY(twice.ok());
    QVERIFY(once->bytes == twice->bytes);
}

void CanvasStorageTest::theSchemaKnowsAllOfIt()
{
    const Result<SerializedProject> bytes = serializedProject(projectOf(sceneOfTwo()));
    QVERIFY(bytes.ok());
    const Result<std::vector<std::string>> violations = projectSchemaViolations(bytes->bytes, "test.ductus");
    QVERIFY(violations.ok());
    QVERIFY2(violations->empty(), violations->empty() ? "" : violations->front().c_str());
}

void CanvasStorageTest::withoutDrawingsThereIsNoScene()
{
    const Result<SerializedProject> bytes = serializedProject(projectOf({}));
    QVERIFY(bytes.ok());
    const auto content = doodleOf(*reread(bytes->bytes));
    QVERIFY(content.ok());
    QVERIFY((*content)->scene()->canvases.empty());
}

void CanvasStorageTest::whatAReaderWouldRefuseIsNotWritten()
{
    DoodleScene beyond = sceneOfTwo();
    beyond.canvases[1].keyframes.positions[0].frame = frames;
    QVERIFY(!serializedProject(projectOf(beyond)).ok());
    DoodleScene unordered = sceneOfTwo();
    std::swap(unordered.canvases[0].keyframes.positions[0], unordered.canvases[0].keyframes.positions[1]);
    QVERIFY(!serializedProject(projectOf(unordered)).ok());
    DoodleScene nowhere = sceneOfTwo();
    nowhere.canvases[0].keyframes.positions.clear();
    QVERIFY(!serializedProject(projectOf(nowhere)).ok());
    DoodleScene unreadable = sceneOfTwo();
    unreadable.canvases[0].name = "\xff";
    QVERIFY(!serializedProject(projectOf(unreadable)).ok());
}

QTEST_APPLESS_MAIN(CanvasStorageTest)
#include "canvas_storage_test.moc"
