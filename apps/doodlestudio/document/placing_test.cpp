// From pointer to canvas: sizes, keyframes and turns with exact numbers.
#include "doodlestudio/document/placing.h"

#include "doodlestudio/document/doodle_document.h"

#include <QtTest>

using namespace ductus;

class PlacingTest : public QObject
{
    Q_OBJECT
private slots:
    void aBoxBecomesACanvasThatFillsIt();
    void aClickMakesACanvasOfUsefulSize();
    void movingPinsWhatFollowsAndMovesWhatStays();
    void followingAndStayingKeepThePlace();
    void tiltingLooksWhereItIsTold();

private:
    Shot mShot = plainShot({"clip.mp4", 10, 640, 480, 25.0});
};

void PlacingTest::aBoxBecomesACanvasThatFillsIt()
{
    const Canvas canvas = canvasInBox(mShot, 3, {100, 80}, {260, 200}, "A");
    QCOMPARE(canvas.keyframes.positions.front().frame, 3);
    QCOMPARE(canvas.keyframes.positions.front().pixel, Vec2(180, 140));
    const Result<CanvasTrack> track = canvasTrack(mShot, canvas, {});
    QVERIFY(track.ok());
    const CanvasView view(mShot.cameras[3], track->frames[3]);
    QVERIFY((*view.pixelOf(-0.5 * canvas.size) - Vec2(100, 80)).norm() < 1e-6);
    QVERIFY((*view.pixelOf(0.5 * canvas.size) - Vec2(260, 200)).norm() < 1e-6);
}

void PlacingTest::aClickMakesACanvasOfUsefulSize()
{
    const Canvas canvas = canvasInBox(mShot, 0, {300, 200}, {302, 201}, "A");
    const double pixels = canvas.size.y() * mShot.cameras[0].focal / mShot.sceneDepth;
    QVERIFY(pixels > 0.25 * mShot.height && pixels < 0.5 * mShot.height);
}

void PlacingTest::movingPinsWhatFollowsAndMovesWhatStays()
{
    const Canvas still = canvasInBox(mShot, 2, {100, 100}, {200, 200}, "A");
    const Result<Canvas> moved = withMiddleAt(still, 6, {50, 60});
    QVERIFY(moved.ok());
    QCOMPARE(moved->keyframes.positions.size(), std::size_t(1));
    QCOMPARE(moved->keyframes.positions.front().frame, 6);
    const Canvas moving = following(still, 2, canvasTrack(mShot, still, {})->frames[2]);
    const Result<Canvas> pinned = withMiddleAt(moving, 6, {50, 60});
    QVERIFY(pinned.ok());
    QCOMPARE(pinned->keyframes.positions.size(), std::size_t(2));
    QCOMPARE(pinned->keyframes.positions[1].pixel, Vec2(50, 60));
    // Once more in the same frame replaces it and keeps what it does afterwards.
    Canvas straight = *pinned;
    straight.keyframes.positions[1].interpolatesNext = true;
    const Result<Canvas> again = withMiddleAt(straight, 6, {51, 61});
    QVERIFY(again.ok());
    QCOMPARE(again->keyframes.positions.size(), std::size_t(2));
    QVERIFY(again->keyframes.positions[1].interpolatesNext);
}

void PlacingTest::followingAndStayingKeepThePlace()
{
    Canvas canvas = canvasInBox(mShot, 0, {100, 100}, {200, 200}, "A");
    canvas.keyframes.turns = {{0, Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Vec3::UnitY())), false}};
    const CanvasFrame place = canvasTrack(mShot, canvas, {})->frames[5];
    const Canvas moving = following(canvas, 5, place);
    QVERIFY(moving.motion == CanvasMotion::Dynamic);
    QCOMPARE(moving.keyframes.turns.front().frame, 5);
    const Canvas still = standingAt(moving, 5, place);
    const CanvasFrame after = canvasTrack(mShot, still, {})->frames[5];
    QVERIFY((after.position - place.position).norm() < 1e-9);
    QVERIFY(after.worldFromCanvas.angularDistance(place.worldFromCanvas) < 1e-9);
}

void PlacingTest::tiltingLooksWhereItIsTold()
{
    const ShotCamera &camera = mShot.cameras[0];
    const Eigen::Quaterniond facing(camera.worldFromCamera.linear());
    QVERIFY((frontInCamera(facing, camera) - Vec3(0, 0, -1)).norm() < 1e-12);
    const Vec3 wanted = Vec3(0.5, -0.4, -0.9).normalized();
    QVERIFY((frontInCamera(tilted(facing, camera, wanted), camera) - wanted).norm() < 1e-9);
    // A quarter clockwise: what was right is down now.
    const Vec3 right = spun(facing, 3.14159265358979323846 / 2) * Vec3(1, 0, 0);
    QVERIFY((camera.worldFromCamera.linear().transpose() * right - Vec3(0, 1, 0)).norm() < 1e-9);
}

QTEST_GUILESS_MAIN(PlacingTest)
#include "placing_test.moc"
