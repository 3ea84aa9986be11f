#include "painting/scene/layer.h"

#include "base/random.h"

#include <QtTest>

using namespace ductus;

namespace {

Placement randomPlacement(Random &random)
{
    const auto number = [&] { return random.uniform() * 2 - 1; };
    Placement placement;
    placement.rotation = Eigen::Quaterniond(number(), number(), number(), number()).normalized();
    placement.scale = 0.2 + 3 * random.uniform();
    placement.mirrored = random.index(2) == 1;
    placement.translation = {number(), number(), number()};
    return placement;
}

Placement at(double x, double scale = 1)
{
    Placement placement;
    placement.translation = {x, 0, 0};
    placement.scale = scale;
    return placement;
}

} // namespace

class MotionTest : public QObject
{
    Q_OBJECT
private slots:
    void placementsMultiplyAsMatrices();
    void placementsComeBackFromMatrices();
    void keysInterpolate();
    void turnsTakeTheShorterArc();
    void camerasInterpolate();
    void timesLoop();
    void framesRepeat();
};

void MotionTest::placementsMultiplyAsMatrices()
{
    Random random(3);
    for (int run = 0; run < 500; ++run) {
        const Placement a = randomPlacement(random), b = randomPlacement(random);
        const Eigen::Matrix4d expected = a.matrix().matrix() * b.matrix().matrix();
        QVERIFY(((a * b).matrix().matrix() - expected).norm() < 1e-12 * (1 + expected.norm()));
    }
}

void MotionTest::placementsComeBackFromMatrices()
{
    Random random(4);
    for (int run = 0; run < 500; ++run) {
        const Placement placement = randomPlacement(random);
        const Placement back = placementOf(placement.matrix());
        QVERIFY((back.matrix().matrix() - placement.matrix().matrix()).norm() < 1e-12);
        QVERIFY(back.isValid());
        QCOMPARE(back.mirrored, placement.mirrored);
    }
    // Quill's other flips are a mirrored x and a half turn.
    Eigen::Affine3d flipped(Eigen::Scaling(1.0, -2.0 / 2, 1.0));
    QVERIFY((placementOf(flipped).matrix().matrix() - flipped.matrix()).norm() < 1e-12);
}

void MotionTest::keysInterpolate()
{
    const std::vector<PlacementKey> keys{{1, at(0), KeyInterpolation::Linear},
                                         {2, at(8, 4), KeyInterpolation::Smooth},
                                         {4, at(0, 1), KeyInterpolation::Hold},
                                         {5, at(100), KeyInterpolation::Linear}};
    QVERIFY(placementAt(keys, 0) == at(0));
    QVERIFY(placementAt(keys, 2) == at(8, 4));
    QVERIFY(placementAt(keys, 99) == at(100));
    QVERIFY(std::abs(placementAt(keys, 1.25).translation.x() - 2) < 1e-12);
    QVERIFY(std::abs(placementAt(keys, 1.5).scale - 2) < 1e-12); // growing evenly
    // Smooth: halfway in the middle, slow at the ends.
    QVERIFY(std::abs(placementAt(keys, 3).translation.x() - 4) < 1e-12);
    QVERIFY(std::abs(placementAt(keys, 2.5).translation.x() - 8 * (1 - 0.15625)) < 1e-12);
    QVERIFY(placementAt(keys, 4.9) == at(0)); // held
    QVERIFY(placementAt({}, 3) == Placement());
}

void MotionTest::turnsTakeTheShorterArc()
{
    const auto turned = [](double degrees) {
        Placement placement;
        placement.rotation = Eigen::AngleAxisd(degrees * EIGEN_PI / 180, Eigen::Vector3d::UnitY());
        return placement;
    };
    const std::vector<PlacementKey> keys{{0, turned(-170), {KeyInterpolation::Linear}},
                                         {1, turned(170), {KeyInterpolation::Linear}}};
    const Eigen::Matrix3d half = placementAt(keys, 0.5).rotation.toRotationMatrix();
    QVERIFY((half - turned(180).rotation.toRotationMatrix()).norm() < 1e-9);
}

void MotionTest::camerasInterpolate()
{
    CameraPath path;
    path.keys = {{0, {0, 0, 0}, Eigen::Quaterniond::Identity(), 40, KeyInterpolation::Linear},
                 {2, {4, 0, 0}, Eigen::Quaterniond::Identity(), 60, KeyInterpolation::Linear}};
    const CameraKey camera = cameraAt(path, 0.5);
    QCOMPARE(camera.eye.x(), 1.0);
    QCOMPARE(camera.verticalViewDegrees, 45.0);
    QCOMPARE(camera.timeSeconds, 0.5);
    QCOMPARE(cameraAt(path, -1).eye.x(), 0.0);
    QCOMPARE(cameraAt(path, 9).eye.x(), 4.0);
}

void MotionTest::timesLoop()
{
    QCOMPARE(loopedTime(7.5, 2), 1.5);
    QCOMPARE(loopedTime(-0.5, 2), 1.5);
    QCOMPARE(loopedTime(7.5, 0), 7.5);
}

void MotionTest::framesRepeat()
{
    Layer layer;
    layer.drawings.resize(3);
    layer.frames = {10, 0, {0, 2, 2, 1}};
    const auto shown = [&](double time) { return int(&layer.drawingAt(time) - layer.drawings.data()); };
    QCOMPARE(shown(0), 0);
    QCOMPARE(shown(0.15), 2);
    QCOMPARE(shown(0.35), 1);
    QCOMPARE(shown(0.45), 0); // again
    QCOMPARE(shown(1e12), shown(0.0));
    QCOMPARE(shown(-3), 0);
    layer.frames.repeatCount = 1;
    QCOMPARE(shown(0.15), 2);
    QCOMPARE(shown(0.45), 1); // stays on the last
}

QTEST_APPLESS_MAIN(MotionTest)
#include "motion_test.moc"
