#include "doodling/tracking/trajectory.h"

#include "base/random.h"

#include <Eigen/Dense>
#include <QtTest>

using namespace ductus;

namespace {

struct Scene
{
    std::vector<FlowStep> steps;
    std::vector<PositionKeyframe> keyframes;
};

Vec3 randomVector(Random &random)
{
    return {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
}

Scene randomScene(std::uint64_t seed, const std::vector<int> &frames, int frameCount)
{
    Random random(seed);
    Scene scene;
    for (int t = 0; t + 1 < frameCount; ++t)
        scene.steps.push_back({0.1 * randomVector(random), random.uniform(0.1, 1.0)});
    for (int frame : frames)
        scene.keyframes.push_back({frame, randomVector(random), randomVector(random) + Vec3(0.0, 0.0, 2.0),
                                   random.uniform(2.0, 6.0), false, false});
    return scene;
}

// Eq. VI.2 written out for all positions, the keyframes by their depths: dense normal equations.
std::vector<Vec3> bruteForce(const Scene &scene, double lambda)
{
    const int frames = int(scene.steps.size()) + 1;
    std::vector<int> keyOf(std::size_t(frames), -1), column(std::size_t(frames), 0);
    for (std::size_t k = 0; k < scene.keyframes.size(); ++k)
        keyOf[std::size_t(scene.keyframes[k].frame)] = int(k);
    int columns = 0;
    for (int t = 0; t < frames; ++t) {
        column[std::size_t(t)] = columns;
        const int k = keyOf[std::size_t(t)];
        columns += k < 0 ? 3 : scene.keyframes[std::size_t(k)].isDepthFixed ? 0 : 1;
    }
    const int rows = 3 * (frames - 1) + 3 * int(scene.keyframes.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, columns);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(rows);
    const auto add = [&](int row, int t, double factor) {
        const int k = keyOf[std::size_t(t)];
        if (k < 0) {
            a.block<3, 3>(row, column[std::size_t(t)]) += factor * Eigen::Matrix3d::Identity();
            return;
        }
        const PositionKeyframe &key = scene.keyframes[std::size_t(k)];
        b.segment<3>(row) -= factor * key.eye;
        if (key.isDepthFixed)
            b.segment<3>(row) -= factor * key.depth * key.ray;
        else
            a.block<3, 1>(row, column[std::size_t(t)]) += factor * key.ray;
    };
    for (int t = 0; t + 1 < frames; ++t) {
        const double w = std::sqrt(scene.steps[std::size_t(t)].confidence);
        b.segment<3>(3 * t) += w * scene.steps[std::size_t(t)].motion;
        add(3 * t, t + 1, w);
        add(3 * t, t, -w);
    }
    for (std::size_t k = 0; k < scene.keyframes.size(); ++k) {
        const PositionKeyframe &key = scene.keyframes[k];
        const int row = 3 * (frames - 1 + int(k));
        b.segment<3>(row) += std::sqrt(lambda) * (key.eye + key.depth * key.ray);
        add(row, key.frame, std::sqrt(lambda));
    }
    const Eigen::VectorXd x = a.colPivHouseholderQr().solve(b);
    std::vector<Vec3> positions;
    for (int t = 0; t < frames; ++t) {
        const int k = keyOf[std::size_t(t)], c = column[std::size_t(t)];
        if (k < 0)
            positions.push_back(x.segment<3>(c));
        else {
            const PositionKeyframe &key = scene.keyframes[std::size_t(k)];
            positions.push_back(key.eye + (key.isDepthFixed ? key.depth : x[c]) * key.ray);
        }
    }
    return positions;
}

double farthest(const std::vector<Vec3> &a, const std::vector<Vec3> &b)
{
    double worst = a.size() == b.size() ? 0.0 : 1e300;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        worst = std::max(worst, (a[i] - b[i]).norm());
    return worst;
}

} // namespace

class TrajectoryTest : public QObject
{
    Q_OBJECT
private slots:
    void equalsTheFullSystem_data();
    void equalsTheFullSystem();
    void oneKeyframeFollowsTheFlow();
    void driftLandsWhereFlowIsNotTrusted();
    void straightSpansIgnoreTheFlow();
    void depthsStayInFrontOfTheCamera();
    void wrongKeyframesAreRefused();
};

void TrajectoryTest::equalsTheFullSystem_data()
{
    QTest::addColumn<QList<int>>("frames");
    QTest::addColumn<QList<int>>("withFixedDepth");
    QTest::newRow("one") << QList<int>{7} << QList<int>{};
    QTest::newRow("ends") << QList<int>{0, 19} << QList<int>{};
    QTest::newRow("neighbours") << QList<int>{4, 5, 6} << QList<int>{};
    QTest::newRow("one fixed") << QList<int>{2, 9, 15} << QList<int>{1};
    QTest::newRow("first and last fixed") << QList<int>{0, 6, 12, 19} << QList<int>{0, 3};
    QTest::newRow("all fixed") << QList<int>{3, 11} << QList<int>{0, 1};
}

void TrajectoryTest::equalsTheFullSystem()
{
    QFETCH(QList<int>, frames);
    QFETCH(QList<int>, withFixedDepth);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Scene scene = randomScene(seed, {frames.begin(), frames.end()}, 20);
        for (int k : withFixedDepth)
            scene.keyframes[std::size_t(k)].isDepthFixed = true;
        TrajectoryOptions options;
        options.nearestDepth = -1e300; // the full system has no such bound
        const auto solved = solveTrajectory(scene.steps, scene.keyframes, options);
        QVERIFY(solved.ok());
        QVERIFY2(farthest(*solved, bruteForce(scene, options.depthWeight)) < 1e-8,
                 qPrintable(QString::number(farthest(*solved, bruteForce(scene, options.depthWeight)))));
    }
}

void TrajectoryTest::oneKeyframeFollowsTheFlow()
{
    const Scene scene = randomScene(3, {5}, 12);
    const auto solved = solveTrajectory(scene.steps, scene.keyframes);
    QVERIFY(solved.ok());
    const PositionKeyframe &key = scene.keyframes[0];
    QVERIFY(((*solved)[5] - (key.eye + key.depth * key.ray)).norm() < 1e-12);
    for (std::size_t t = 0; t + 1 < solved->size(); ++t)
        QVERIFY(((*solved)[t + 1] - (*solved)[t] - scene.steps[t].motion).norm() < 1e-12);
}

void TrajectoryTest::driftLandsWhereFlowIsNotTrusted()
{
    // The object moves one to the right a frame; hidden in frames 4 and 5 the flow says it stands still.
    std::vector<FlowStep> steps(10, FlowStep{Vec3::UnitX(), 1.0});
    steps[4] = steps[5] = {Vec3::Zero(), 1e-3};
    const std::vector<PositionKeyframe> keyframes{{0, Vec3(0, 0, -5), Vec3::UnitZ(), 5.0, true, false},
                                                  {10, Vec3(10, 0, -5), Vec3::UnitZ(), 5.0, true, false}};
    const auto solved = solveTrajectory(steps, keyframes);
    QVERIFY(solved.ok());
    for (std::size_t t = 0; t < solved->size(); ++t)
        QVERIFY(((*solved)[t] - Vec3(double(t), 0.0, 0.0)).norm() < 0.02);
}

void TrajectoryTest::straightSpansIgnoreTheFlow()
{
    Scene scene = randomScene(8, {2, 8, 14}, 16);
    scene.keyframes[0].interpolatesNext = true;
    const auto solved = solveTrajectory(scene.steps, scene.keyframes);
    QVERIFY(solved.ok());
    const PositionKeyframe &first = scene.keyframes[0];
    QVERIFY(((*solved)[2] - (first.eye + first.depth * first.ray)).norm() < 1e-12); // nothing pulls it
    for (std::size_t t = 2; t <= 8; ++t)
        QVERIFY(
            ((*solved)[t] - ((*solved)[2] + ((*solved)[8] - (*solved)[2]) * (double(t - 2) / 6.0))).norm() <
            1e-12);
    const Scene second{{scene.steps.begin() + 8, scene.steps.end()},
                       {scene.keyframes[1], scene.keyframes[2]}};
    std::vector<PositionKeyframe> shifted = second.keyframes;
    for (PositionKeyframe &key : shifted)
        key.frame -= 8;
    const auto alone = solveTrajectory(second.steps, shifted);
    QVERIFY(alone.ok());
    for (std::size_t t = 0; t < alone->size(); ++t)
        QVERIFY(((*alone)[t] - (*solved)[t + 8]).norm() < 1e-12);
}

void TrajectoryTest::depthsStayInFrontOfTheCamera()
{
    // The flow runs towards the camera and through it.
    std::vector<FlowStep> steps(4, FlowStep{-5.0 * Vec3::UnitZ(), 1.0});
    const std::vector<PositionKeyframe> keyframes{{0, Vec3::Zero(), Vec3::UnitZ(), 2.0, true, false},
                                                  {4, Vec3::Zero(), Vec3::UnitZ(), 2.0, false, false}};
    const auto solved = solveTrajectory(steps, keyframes);
    QVERIFY(solved.ok());
    QVERIFY((*solved)[4].z() > 0.0);
}

void TrajectoryTest::wrongKeyframesAreRefused()
{
    const Scene good = randomScene(1, {3, 6}, 10);
    QVERIFY(!solveTrajectory(good.steps, {}).ok());
    for (int frame : {6, -1, 10, 2}) { // twice, before, beyond, out of order
        Scene bad = good;
        bad.keyframes[frame == -1 ? 0 : 1].frame = frame == 6 ? 3 : frame;
        QVERIFY(!solveTrajectory(bad.steps, bad.keyframes).ok());
    }
    Scene bad = good;
    bad.keyframes[0].depth = std::nan("");
    QVERIFY(!solveTrajectory(bad.steps, bad.keyframes).ok());
    bad = good;
    bad.steps[4].confidence = 0.0;
    QVERIFY(!solveTrajectory(bad.steps, bad.keyframes).ok());
    QVERIFY(solveTrajectory({}, {good.keyframes[0]}).ok() == false); // frame 3 of a clip of one frame
}

QTEST_APPLESS_MAIN(TrajectoryTest)
#include "trajectory_test.moc"
