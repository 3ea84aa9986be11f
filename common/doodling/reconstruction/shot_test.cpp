#include "doodling/reconstruction/shot.h"

#include "support/clip_scenes.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int width = 320, height = 180, frames = 16;

double median(std::vector<double> values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

class ShotTest : public QObject
{
    Q_OBJECT
private slots:
    void aMovingCameraShowsDepth()
    {
        const ClipScene scene = passingScene(width, height, frames);
        const std::unique_ptr<Clip> clip = clipOf(scene);
        const Result<Shot> shot = reconstructShot(*clip, {}, {});
        QVERIFY(shot.ok());
        QCOMPARE(shot->knowledge, CameraKnowledge::SolvedCameras);
        QCOMPARE(int(shot->depths.size()), frames);
        std::vector<double> ratios, misses;
        int moving = 0, found = 0, wrong = 0;
        const ClipTruth truth = renderedFrame(scene, 6);
        for (int y = 2; y < height; y += 4)
            for (int x = 2; x < width; x += 4) {
                const std::size_t i = std::size_t(y * width + x);
                const bool moves = scene.bodies[std::size_t(truth.bodies[i])].worldFromBody != nullptr;
                const bool isFound = shot->objectAt(6, {x + 0.5, y + 0.5}) > 0;
                moving += moves;
                found += moves && isFound;
                wrong += !moves && isFound;
                if (!moves)
                    ratios.push_back(shot->depthAt(6, {x + 0.5, y + 0.5}) / double(truth.depths[i]));
            }
        const double scale = median(ratios);
        for (double ratio : ratios)
            misses.push_back(std::abs(ratio / scale - 1.0));
        QVERIFY2(median(misses) < 0.03, qPrintable(QString::number(median(misses))));
        QVERIFY2(found > 0.8 * moving && wrong < 0.4 * moving,
                 qPrintable(QString("%1 of %2, %3 wrong").arg(found).arg(moving).arg(wrong)));
        // The camera's way, after one scale.
        const Vec3 way = shot->cameras.back().position() - shot->cameras.front().position();
        const Vec3 trueWay = scene.camera(frames - 1).position() - scene.camera(0).position();
        QVERIFY(std::abs(way.norm() / (scale * trueWay.norm()) - 1.0) < 0.05);
    }
    void aTurningCameraIsSaidToTurn()
    {
        const ClipScene scene = panScene(width, height, frames);
        const Result<Shot> shot = reconstructShot(*clipOf(scene), {}, {});
        QVERIFY(shot.ok());
        QCOMPARE(shot->knowledge, CameraKnowledge::RotationOnly);
        const Eigen::Matrix3d turn = shot->cameras.front().worldFromCamera.linear().transpose() *
                                     shot->cameras.back().worldFromCamera.linear();
        const Eigen::Matrix3d trueTurn = scene.camera(0).worldFromCamera.linear().transpose() *
                                         scene.camera(frames - 1).worldFromCamera.linear();
        QVERIFY(Eigen::AngleAxisd(Eigen::Matrix3d(turn.transpose() * trueTurn)).angle() < 0.02);
    }
    void aStandingCameraIsSaidToStand()
    {
        const ClipScene scene = tripodScene(width, height, frames);
        const Result<Shot> shot = reconstructShot(*clipOf(scene), {}, {});
        QVERIFY(shot.ok());
        QCOMPARE(shot->knowledge, CameraKnowledge::Tripod);
        QVERIFY(shot->cameras.back().worldFromCamera.isApprox(shot->cameras.front().worldFromCamera));
        // What stands on the floor lower in the picture is nearer.
        QVERIFY(shot->depthAt(0, {10.5, height - 2.0}) < shot->depthAt(0, {10.5, 0.6 * height}));
    }
    void shortAndEmptyClipsAreTakenToo()
    {
        for (int count : {1, 2, 3}) {
            ClipScene scene = sidewaysScene(64, 36, count);
            const Result<Shot> shot = reconstructShot(*clipOf(scene), {}, {});
            QVERIFY(shot.ok());
            QCOMPARE(shot->frameCount(), count);
            QVERIFY(std::isfinite(shot->depthAt(count - 1, {30.0, 20.0})));
        }
        ClipScene black = tripodScene(64, 36, 6);
        black.bodies.clear(); // nothing but a plain sky
        const Result<Shot> shot = reconstructShot(*clipOf(black), {}, {});
        QVERIFY(shot.ok());
        QCOMPARE(shot->knowledge, CameraKnowledge::Tripod);
        QVERIFY(shot->depthAt(3, {30.0, 20.0}) > 0.0);
    }
    void cancellingEndsIt()
    {
        std::atomic<bool> cancelled = true;
        const Result<Shot> shot =
            reconstructShot(*clipOf(sidewaysScene(64, 36, 5)), {}, JobControl(&cancelled, {}));
        QVERIFY(!shot.ok() && shot.error().isCancelled());
    }
};

QTEST_APPLESS_MAIN(ShotTest)
#include "shot_test.moc"
