#include "surfacing/proxy/point_subset.h"

#include "base/random.h"

#include <QtTest>
#include <set>

using namespace ductus;

namespace {

std::vector<Vec3> cloud(int count)
{
    Random random(4);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform(), y = random.uniform();
        points.push_back({x, y, random.uniform()});
    }
    return points;
}

double distanceToSet(const Vec3 &p, const std::vector<Vec3> &points, const std::vector<int> &chosen,
                     std::size_t count)
{
    double best = 1e300;
    for (std::size_t i = 0; i < count; ++i)
        best = std::min(best, (p - points[chosen[i]]).norm());
    return best;
}

} // namespace

class PointSubsetTest : public QObject
{
    Q_OBJECT
private slots:
    void eachNextIsTheFarthest();
    void startsFarFromTheCentroid();
    void keepsTheMinimumDistance();
    void endsWithItsPoints();
    void equalPointsAreTakenOnce();
    void spreadingOutKeepsTheDistance();
    void medianSpacingIsTheCommonOne();
};

void PointSubsetTest::eachNextIsTheFarthest()
{
    const std::vector<Vec3> points = cloud(200);
    const std::vector<int> chosen = farthestPoints(points, 40, 0.0);
    QCOMPARE(chosen.size(), std::size_t(40));
    QCOMPARE(std::set<int>(chosen.begin(), chosen.end()).size(), std::size_t(40));
    for (std::size_t i = 1; i < chosen.size(); ++i) {
        const double own = distanceToSet(points[chosen[i]], points, chosen, i);
        for (const Vec3 &p : points)
            QVERIFY(distanceToSet(p, points, chosen, i) <= own + 1e-15);
    }
    QVERIFY(farthestPoints(points, 40, 0.0) == chosen);
}

void PointSubsetTest::startsFarFromTheCentroid()
{
    std::vector<Vec3> points = cloud(50);
    points[37] = {4, 0, 0};
    QCOMPARE(farthestPoints(points, 3, 0.0).front(), 37);
}

void PointSubsetTest::keepsTheMinimumDistance()
{
    const std::vector<Vec3> points = cloud(400);
    const std::vector<int> chosen = farthestPoints(points, 400, 0.2);
    QVERIFY(chosen.size() > 20 && chosen.size() < 200);
    for (std::size_t i = 0; i < chosen.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY((points[chosen[i]] - points[chosen[j]]).norm() >= 0.2);
    for (const Vec3 &p : points) // and stops no earlier
        QVERIFY(distanceToSet(p, points, chosen, chosen.size()) <= 0.2);
}

void PointSubsetTest::endsWithItsPoints()
{
    QVERIFY(farthestPoints({}, 5, 0.0).empty());
    QVERIFY(farthestPoints(cloud(5), 0, 0.0).empty());
    QVERIFY(farthestPoints(cloud(5), -3, 0.0).empty());
    QCOMPARE(farthestPoints(cloud(5), 50, 0.0).size(), std::size_t(5));
    QCOMPARE(farthestPoints(cloud(1), 1, 0.0), std::vector<int>{0});
}

void PointSubsetTest::equalPointsAreTakenOnce()
{
    std::vector<Vec3> points(30, Vec3(1, 2, 3));
    points.push_back({1, 2, 4});
    QCOMPARE(farthestPoints(points, 10, 0.0).size(), std::size_t(2));
}

void PointSubsetTest::spreadingOutKeepsTheDistance()
{
    const std::vector<Vec3> points = cloud(2000);
    const std::vector<Vec3> kept = spreadOut(points, 0.1);
    QVERIFY(kept.size() > 100 && kept.size() < 1500);
    QCOMPARE(kept.front(), points.front());
    for (std::size_t i = 0; i < kept.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY((kept[i] - kept[j]).norm() > 0.1);
    for (const Vec3 &p : points) {
        double nearest = 1e300;
        for (const Vec3 &q : kept)
            nearest = std::min(nearest, (p - q).norm());
        QVERIFY(nearest <= 0.1);
    }
    QVERIFY(spreadOut({}, 0.1).empty());
    QCOMPARE(spreadOut(std::vector<Vec3>(5, Vec3(1, 2, 3)), 0.0).size(), std::size_t(1));
}

void PointSubsetTest::medianSpacingIsTheCommonOne()
{
    std::vector<Vec3> points;
    for (int i = 0; i < 40; ++i)
        points.push_back({0.5 * i, 0.0, 0.0});
    points.push_back({100.0, 0.0, 0.0});
    QCOMPARE(medianSpacing(points), 0.5);
    QCOMPARE(medianSpacing({}), 0.0);
    QCOMPARE(medianSpacing({Vec3::Zero()}), 0.0);
}

QTEST_APPLESS_MAIN(PointSubsetTest)
#include "point_subset_test.moc"
