#include "doodling/canvas/canvas_view.h"

#include "doodling/canvas/canvas.h"

#include <QtTest>

using namespace ductus;

namespace {

ShotCamera cameraAt(const Vec3 &position)
{
    ShotCamera camera;
    camera.worldFromCamera.pretranslate(position);
    camera.focal = 400.0;
    camera.centre = Vec2(320.0, 240.0);
    return camera;
}

CanvasFrame placeAt(const Vec3 &position, double turnDegrees = 0.0, double scale = 1.0)
{
    CanvasFrame place;
    place.position = position;
    place.worldFromCanvas = Eigen::AngleAxisd(turnDegrees * M_PI / 180.0, Vec3::UnitY());
    place.scale = scale;
    return place;
}

bool isNear(const Vec2 &a, const Vec2 &b, double tolerance = 1e-9)
{
    return (a - b).norm() < tolerance;
}

} // namespace

class CanvasViewTest : public QObject
{
    Q_OBJECT
private slots:
    void facingSheetsAreScaledOnly()
    {
        const CanvasView view(cameraAt(Vec3::Zero()), placeAt({0.5, 0.0, 4.0}, 0.0, 2.0));
        // A unit is 2 scene units here: 200 pixels; the middle 50 to the right.
        QVERIFY(isNear(*view.pixelOf({0.0, 0.0}), {370.0, 240.0}));
        QVERIFY(isNear(*view.pixelOf({1.0, -0.5}), {570.0, 140.0}));
        QVERIFY(isNear(*view.canvasPointOf({570.0, 140.0}), {1.0, -0.5}));
        QVERIFY(std::abs(view.pixelsAUnit() - 200.0) < 2.0);
        QVERIFY(!view.isFromBehind());
    }
    void turnedSheetsAreSeenInPerspective()
    {
        // Turned by 60 degrees about the vertical: the right edge (x = 1) is at depth 4 - sin 60, half as far
        // right in space.
        const CanvasView view(cameraAt(Vec3::Zero()), placeAt({0.0, 0.0, 4.0}, 60.0));
        const double depth = 4.0 - std::sin(M_PI / 3.0);
        QVERIFY(isNear(*view.pixelOf({1.0, 1.0}), {320.0 + 400.0 * 0.5 / depth, 240.0 + 400.0 / depth}));
        QVERIFY(std::abs(view.depthOf({1.0, 0.3}) - depth) < 1e-12);
        QVERIFY(std::abs(view.facing() - 0.5) < 1e-12);
    }
    void bothWaysAndBackAgain()
    {
        ShotCamera camera = cameraAt({0.3, -0.2, 0.1});
        camera.worldFromCamera.rotate(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()));
        for (double turn : {-70.0, -10.0, 25.0, 80.0}) {
            const CanvasView view(camera, placeAt({0.4, 0.2, 3.0}, turn, 0.7));
            for (const Vec2 &point : {Vec2(0.0, 0.0), Vec2(0.5, -0.5), Vec2(-0.31, 0.44)}) {
                const std::optional<Vec2> pixel = view.pixelOf(point);
                QVERIFY(pixel.has_value());
                QVERIFY(isNear(*view.canvasPointOf(*pixel), point, 1e-8));
                QVERIFY(isNear(*camera.projected(view.worldPointOf(point)), *pixel, 1e-8));
            }
        }
    }
    void whatIsBehindIsNotSeen()
    {
        const CanvasView behind(cameraAt(Vec3::Zero()), placeAt({0.0, 0.0, -4.0}));
        QVERIFY(!behind.pixelOf({0.0, 0.0}));
        QVERIFY(!behind.canvasPointOf({320.0, 240.0}));
        // A floor under the camera: rays above the horizon never meet it.
        CanvasFrame floor = placeAt({0.0, 1.0, 3.0});
        floor.worldFromCanvas = Eigen::AngleAxisd(-M_PI / 2.0, Vec3::UnitX());
        const CanvasView view(cameraAt(Vec3::Zero()), floor);
        QVERIFY(view.canvasPointOf({320.0, 300.0}).has_value());
        QVERIFY(!view.canvasPointOf({320.0, 180.0}));
        const CanvasView edge(cameraAt(Vec3::Zero()), placeAt({0.0, 0.0, 4.0}, 90.0));
        QVERIFY(edge.facing() < 1e-9);
        QVERIFY(!edge.canvasPointOf({400.0, 240.0}));
    }
    void theBackIsMirrored()
    {
        const CanvasView view(cameraAt(Vec3::Zero()), placeAt({0.0, 0.0, 4.0}, 180.0));
        QVERIFY(view.isFromBehind());
        QVERIFY(view.pixelOf({1.0, 0.0})->x() < 320.0);
    }
    void rectifyingUndoesThePerspective()
    {
        // Black and white squares of a quarter unit on a turned sheet.
        const CanvasView view(cameraAt(Vec3::Zero()), placeAt({0.1, 0.0, 3.0}, 40.0));
        const auto isWhite = [](const Vec2 &p) {
            return (int(std::floor(4.0 * p.x())) + int(std::floor(4.0 * p.y()))) % 2 == 0;
        };
        Image picture(640, 480, {0, 0, 0, 255});
        for (int y = 0; y < 480; ++y)
            for (int x = 0; x < 640; ++x)
                if (const auto point = view.canvasPointOf({x + 0.5, y + 0.5}); point && isWhite(*point))
                    picture.set(x, y, {255, 255, 255, 255});
        const Image flat = rectified(picture, view, {2.0, 1.0}, 200, 100);
        int wrong = 0, checked = 0;
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 200; ++x) {
                const Vec2 point((x + 0.5) / 100.0 - 1.0, (y + 0.5) / 100.0 - 0.5);
                const Vec2 inSquare(4.0 * point.x() - std::floor(4.0 * point.x()),
                                    4.0 * point.y() - std::floor(4.0 * point.y()));
                if ((inSquare - Vec2(0.5, 0.5)).cwiseAbs().maxCoeff() > 0.4)
                    continue; // at the rims colours mix
                ++checked;
                wrong += (flat.at(x, y)[0] > 127) != isWhite(point);
            }
        QVERIFY(checked > 10000);
        QCOMPARE(wrong, 0);
        // Beyond the picture nothing is made up.
        const Image wide = rectified(picture, view, {20.0, 1.0}, 200, 10);
        QCOMPARE(int(wide.at(0, 5)[3]), 0);
    }
    void standingCanvasesStayInTheScene()
    {
        Shot shot;
        shot.width = shot.clipWidth = 640;
        shot.height = shot.clipHeight = 480;
        for (int t = 0; t < 5; ++t)
            shot.cameras.push_back(cameraAt({0.1 * t, 0.0, 0.0}));
        shot.sceneDepth = 4.0;
        Canvas canvas;
        canvas.keyframes.positions = {{2, Vec2(320.0, 240.0), std::nullopt, false}};
        const Result<CanvasTrack> track = canvasTrack(shot, canvas, {});
        QVERIFY(track.ok());
        QCOMPARE(int(track->frames.size()), 5);
        for (int t = 0; t < 5; ++t) {
            const CanvasFrame &frame = track->frames[std::size_t(t)];
            QVERIFY((frame.position - Vec3(0.2, 0.0, 4.0)).norm() < 1e-12);
            QVERIFY(isNear(frame.pixel, {320.0 + 10.0 * (2 - t), 240.0}));
            QVERIFY(frame.isVisible);
        }
        canvas.keyframes.positions.clear();
        QVERIFY(!canvasTrack(shot, canvas, {}).ok());
        canvas.keyframes.positions = {{7, Vec2(320.0, 240.0), std::nullopt, false}};
        QVERIFY(!canvasTrack(shot, canvas, {}).ok());
    }
    void shownBetweenItsFrames()
    {
        Canvas canvas;
        QVERIFY(isShownIn(canvas, 0) && isShownIn(canvas, 1000));
        canvas.shownFrom = 3;
        canvas.shownUntil = 5;
        QVERIFY(!isShownIn(canvas, 2) && isShownIn(canvas, 3) && isShownIn(canvas, 5) &&
                !isShownIn(canvas, 6));
        canvas.isVisible = false;
        QVERIFY(!isShownIn(canvas, 4));
    }
};

QTEST_APPLESS_MAIN(CanvasViewTest)
#include "canvas_view_test.moc"
