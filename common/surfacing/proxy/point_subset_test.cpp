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

QTEST_APPLESS_MAIN(PointSubsetTest)
#include "point_subset_test.moc"
