#include "surfacing/sketch/point_cloud.h"

#include "base/random.h"

#include <QtTest>

using namespace ductus;

namespace {

StrokeSet cloudOf(const std::vector<Vec3> &points)
{
    StrokeSet cloud;
    for (const Vec3 &p : points) {
        Stroke stroke;
        stroke.id.value = int(cloud.strokes.size());
        stroke.points = {p};
        cloud.strokes.push_back(stroke);
    }
    return cloud;
}

std::vector<Vec3> spherePoints(int count, double noise)
{
    Random random(2);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i)
        points.push_back(Vec3(random.normal(), random.normal(), random.normal()).normalized() *
                         (1.0 + noise * random.normal()));
    return points;
}

} // namespace

class PointCloudTest : public QObject
{
    Q_OBJECT
private slots:
    void toldFromStrokes();
    void repeatedPointsAreDropped();
    void surfacesAreTaken();
    void volumesAndHandfulsAreRefused();
};

void PointCloudTest::toldFromStrokes()
{
    StrokeSet cloud = cloudOf(spherePoints(200, 0.0));
    QVERIFY(isPointCloud(cloud));
    QVERIFY(!isPointCloud(cloudOf(spherePoints(10, 0.0)))); // dots in a sketch
    for (std::size_t s = 0; s < 60; ++s)
        cloud.strokes[s].points.push_back(Vec3::Zero());
    QVERIFY(!isPointCloud(cloud));
    QVERIFY(!isPointCloud({}));
}

void PointCloudTest::repeatedPointsAreDropped()
{
    std::vector<Vec3> points = spherePoints(100, 0.0);
    points[40] = points[7];
    points[80] = points[7];
    const StrokeSet kept = cleanedCloud(cloudOf(points));
    QCOMPARE(kept.strokes.size(), std::size_t(98));
    QCOMPARE(kept.strokes[7].id.value, 7); // the first of them stays
    QCOMPARE(kept.strokes[40].id.value, 41);
}

void PointCloudTest::surfacesAreTaken()
{
    for (double noise : {0.0, 0.01, 0.03})
        QVERIFY(checkCloudIsSurface(cloudOf(spherePoints(1000, noise))).ok());
    QVERIFY(checkCloudIsSurface(cloudOf(spherePoints(100, 0.0))).ok());
}

void PointCloudTest::volumesAndHandfulsAreRefused()
{
    Random random(4);
    std::vector<Vec3> filled;
    for (int i = 0; i < 500; ++i)
        filled.push_back({random.uniform(), random.uniform(), random.uniform()});
    const Result<void> volume = checkCloudIsSurface(cloudOf(filled));
    QVERIFY(!volume.ok());
    QCOMPARE(volume.error().code, ErrorCode::NoSolution);
    const Result<void> few = checkCloudIsSurface(cloudOf(spherePoints(60, 0.0)));
    QVERIFY(!few.ok());
    QCOMPARE(few.error().code, ErrorCode::TooLittleData);
    QVERIFY(few.error().message().find("60 points") != std::string::npos);
}

QTEST_APPLESS_MAIN(PointCloudTest)
#include "point_cloud_test.moc"
