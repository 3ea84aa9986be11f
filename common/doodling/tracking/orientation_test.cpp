#include "doodling/tracking/orientation.h"

#include "doodling/tracking/motion_direction.h"

#include <QtTest>
#include <numbers>

using namespace ductus;
using Eigen::AngleAxisd;
using Eigen::Quaterniond;

namespace {

// A quarter turn on a circle in the x-y plane: where it goes turns by 90 degrees.
std::vector<Vec3> quarterTurn(int frames)
{
    std::vector<Vec3> trajectory;
    for (int t = 0; t < frames; ++t) {
        const double u = 0.5 * std::numbers::pi * t / (frames - 1);
        trajectory.push_back(5.0 * Vec3(std::sin(u), 1.0 - std::cos(u), 0.0));
    }
    return trajectory;
}

double degreesBetween(const Quaterniond &a, const Quaterniond &b)
{
    return a.angularDistance(b) * 180.0 / std::numbers::pi;
}

Quaterniond about(const Vec3 &axis, double degrees)
{
    return Quaterniond(AngleAxisd(degrees * std::numbers::pi / 180.0, axis.normalized()));
}

} // namespace

class OrientationTest : public QObject
{
    Q_OBJECT
private slots:
    void theCanvasTurnsWithTheTrajectory_data();
    void theCanvasTurnsWithTheTrajectory();
    void keyframesAreExact();
    void smoothnessAlonePassesEvenlyBetweenKeyframes();
    void anAbruptTurnDoesNotTurnTheCanvas();
    void stillTrajectoriesKeepTheOrientation();
    void wrongKeyframesAreRefused();
    void cancelled();
};

void OrientationTest::theCanvasTurnsWithTheTrajectory_data()
{
    QTest::addColumn<double>("tilt");
    QTest::newRow("along") << 0.0;
    QTest::newRow("askew") << 70.0;
}

void OrientationTest::theCanvasTurnsWithTheTrajectory()
{
    QFETCH(double, tilt);
    const std::vector<Vec3> trajectory = quarterTurn(81);
    const Quaterniond first = about(Vec3(0.3, 1.0, 0.2), tilt);
    OrientationOptions options;
    options.smoothness = 0.1; // follows closely
    const auto solved = solveOrientations(trajectory, {{0, first}}, options);
    QVERIFY(solved.ok());
    // Rigidly with the motion: turned about z by as much as the direction is.
    const double turned = degreesBetween(solved->back(), about(Vec3::UnitZ(), 90.0) * first);
    QVERIFY2(turned < 6.0, qPrintable(QString::number(turned)));
    const double halfway = degreesBetween((*solved)[40], about(Vec3::UnitZ(), 45.0) * first);
    QVERIFY2(halfway < 5.0, qPrintable(QString::number(halfway)));
}

void OrientationTest::keyframesAreExact()
{
    const Quaterniond a = about(Vec3(1, 2, 3), 40.0), b = about(Vec3(-1, 0.5, 0), 100.0);
    const auto solved = solveOrientations(quarterTurn(60), {{5, a}, {44, b}});
    QVERIFY(solved.ok());
    QVERIFY(degreesBetween((*solved)[5], a) < 1e-6);
    QVERIFY(degreesBetween((*solved)[44], b) < 1e-6);
    for (std::size_t t = 0; t + 1 < solved->size(); ++t)
        QVERIFY(degreesBetween((*solved)[t], (*solved)[t + 1]) < 10.0);
}

void OrientationTest::smoothnessAlonePassesEvenlyBetweenKeyframes()
{
    const std::vector<Vec3> still(21, Vec3(1, 2, 3));
    const auto solved =
        solveOrientations(still, {{0, Quaterniond::Identity()}, {20, about(Vec3::UnitY(), 80.0)}});
    QVERIFY(solved.ok());
    for (int t = 0; t <= 20; ++t)
        QVERIFY(degreesBetween((*solved)[std::size_t(t)], about(Vec3::UnitY(), 4.0 * t)) < 0.05);
}

void OrientationTest::anAbruptTurnDoesNotTurnTheCanvas()
{
    // There and back, with a stop between: a ball that bounces.
    std::vector<Vec3> trajectory;
    for (int t = 0; t < 20; ++t)
        trajectory.push_back(Vec3(0.5 * t, 0.0, 0.0));
    for (int t = 0; t < 4; ++t)
        trajectory.push_back(trajectory.back());
    for (int t = 0; t < 20; ++t)
        trajectory.push_back(trajectory.back() - Vec3(0.5, 0.0, 0.0));
    const MotionDirection motion = motionDirections(trajectory, {});
    QCOMPARE(motion.segmentCount, 2);
    QVERIFY(motion.directions[10].isApprox(Vec3::UnitX()));
    QVERIFY(motion.directions[35].isApprox(Vec3(-Vec3::UnitX())));
    QCOMPARE(motion.weights[21], 0.0);
    const auto solved = solveOrientations(trajectory, {{0, about(Vec3::UnitY(), 30.0)}});
    QVERIFY(solved.ok());
    for (const Quaterniond &rotation : *solved)
        QVERIFY(degreesBetween(rotation, about(Vec3::UnitY(), 30.0)) < 1.0);
}

void OrientationTest::stillTrajectoriesKeepTheOrientation()
{
    const Quaterniond key = about(Vec3(1, 1, 0), 50.0);
    for (int frames : {1, 2, 30}) {
        const auto solved =
            solveOrientations(std::vector<Vec3>(std::size_t(frames), Vec3::Zero()), {{0, key}});
        QVERIFY(solved.ok());
        QCOMPARE(int(solved->size()), frames);
        for (const Quaterniond &rotation : *solved)
            QVERIFY(degreesBetween(rotation, key) < 1e-3);
    }
}

void OrientationTest::wrongKeyframesAreRefused()
{
    const std::vector<Vec3> trajectory = quarterTurn(10);
    const Quaterniond one = Quaterniond::Identity();
    QVERIFY(!solveOrientations(trajectory, {}).ok());
    QVERIFY(!solveOrientations(trajectory, {{10, one}}).ok());
    QVERIFY(!solveOrientations(trajectory, {{4, one}, {4, one}}).ok());
    QVERIFY(!solveOrientations(trajectory, {{4, Quaterniond(0, 0, 0, 0)}}).ok());
    QVERIFY(!solveOrientations(trajectory, {{4, Quaterniond(std::nan(""), 0, 0, 0)}}).ok());
}

void OrientationTest::cancelled()
{
    const std::atomic<bool> cancel = true;
    const auto result =
        solveOrientations(quarterTurn(10), {{0, Quaterniond::Identity()}}, {}, JobControl(&cancel, {}));
    QVERIFY(!result.ok());
    QVERIFY(result.error().isCancelled());
}

QTEST_APPLESS_MAIN(OrientationTest)
#include "orientation_test.moc"
