#include "doodling/reconstruction/cameras/camera_fit.h"

#include "base/random.h"

#include <QtTest>

using namespace ductus;

namespace {

ShotCamera lens()
{
    return {Eigen::Isometry3d::Identity(), 400.0, {320.0, 180.0}};
}

ShotCamera moved(const Vec3 &place, double turn)
{
    ShotCamera camera = lens();
    camera.worldFromCamera =
        Eigen::Translation3d(place) * Eigen::AngleAxisd(turn, Vec3(0.2, 1.0, 0.1).normalized());
    return camera;
}

std::vector<PointSighting> sightingsFrom(const ShotCamera &camera, double noise, double wrongShare)
{
    Random random(3);
    std::vector<PointSighting> sightings;
    while (sightings.size() < 80) {
        const Vec3 point(random.uniform(-4, 4), random.uniform(-2, 2), random.uniform(4, 12));
        const std::optional<Vec2> seen = camera.projected(point);
        Vec2 pixel = *seen + noise * Vec2(random.normal(), random.normal());
        if (random.uniform() < wrongShare)
            pixel += Vec2(random.uniform(-60, 60), random.uniform(-60, 60));
        sightings.push_back({HomogeneousPoint(point.x(), point.y(), point.z(), 1.0), pixel});
    }
    return sightings;
}

} // namespace

class CameraFitTest : public QObject
{
    Q_OBJECT
private slots:
    void findsAMovedCameraAmongWrongSightings()
    {
        const ShotCamera truth = moved({0.4, -0.1, 0.3}, 0.08);
        ShotCamera camera = lens();
        const CameraFit fit = fitCamera(camera, sightingsFrom(truth, 0.2, 0.3), false);
        QVERIFY((camera.position() - truth.position()).norm() < 0.02);
        QVERIFY(camera.worldFromCamera.linear().isApprox(truth.worldFromCamera.linear(), 2e-3));
        QVERIFY(fit.inliers >= 50 && fit.inliers <= 75);
    }
    void turnsOnTheSpot()
    {
        const ShotCamera truth = moved(Vec3::Zero(), 0.15);
        std::vector<PointSighting> sightings = sightingsFrom(truth, 0.0, 0.0);
        for (PointSighting &sighting : sightings)
            sighting.point.w() = 0.0; // directions
        ShotCamera camera = lens();
        const CameraFit fit = fitCamera(camera, sightings, true);
        QVERIFY(camera.position().norm() == 0.0);
        QVERIFY(camera.worldFromCamera.linear().isApprox(truth.worldFromCamera.linear(), 1e-9));
        QCOMPARE(fit.inliers, 80);
    }
    void findsInverseDepths_data()
    {
        QTest::addColumn<double>("depth");
        QTest::newRow("near") << 2.0;
        QTest::newRow("far") << 40.0;
    }
    void findsInverseDepths()
    {
        QFETCH(double, depth);
        const ShotCamera camera = lens();
        const Vec2 pixel(250.0, 120.0);
        const Vec3 point = camera.unprojected(pixel, depth);
        std::vector<ShotCamera> others;
        for (int i = 1; i <= 5; ++i)
            others.push_back(moved({0.1 * i, 0.02 * i, 0.0}, 0.01 * i));
        std::vector<RaySighting> rays;
        for (const ShotCamera &other : others)
            rays.push_back({&other, *other.projected(point), 1.0});
        rays.push_back({&others[4], Vec2(10.0, 300.0), 1.0}); // a slip
        const InverseDepthFit fit = fitInverseDepth(camera, pixel, rays, 0.1);
        QVERIFY(std::abs(fit.inverseDepth - 1.0 / depth) < 2e-3);
        QVERIFY(fit.information > 0.0);
    }
    void aRayAloneSaysNothing()
    {
        const ShotCamera camera = lens();
        const InverseDepthFit fit = fitInverseDepth(camera, {10, 10}, {}, 0.3);
        QCOMPARE(fit.information, 0.0);
        const std::vector<RaySighting> same = {{&camera, {10, 10}, 1.0}};
        QVERIFY(fitInverseDepth(camera, {10, 10}, same, 0.3).information < 1e-9);
    }
};

QTEST_APPLESS_MAIN(CameraFitTest)
#include "camera_fit_test.moc"
