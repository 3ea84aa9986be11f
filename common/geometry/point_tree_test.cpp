#include "geometry/point_tree.h"

#include "base/random.h"

#include <QtTest>
#include <algorithm>

using namespace ductus;

namespace {

std::vector<Vec3> randomPoints(int count, bool onGrid)
{
    Random random(7);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        Vec3 p(random.uniform(), random.uniform(), random.uniform());
        if (onGrid) // many equal coordinates and distances
            p = (5.0 * p).array().floor();
        points.push_back(p);
    }
    return points;
}

std::vector<int> sortedByDistance(const std::vector<Vec3> &points, const Vec3 &query)
{
    std::vector<int> order;
    for (int i = 0; i < int(points.size()); ++i)
        order.push_back(i);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return std::make_pair((points[std::size_t(a)] - query).squaredNorm(), a) <
               std::make_pair((points[std::size_t(b)] - query).squaredNorm(), b);
    });
    return order;
}

} // namespace

class PointTreeTest : public QObject
{
    Q_OBJECT
private slots:
    void agreesWithBruteForce_data();
    void agreesWithBruteForce();
    void smallSets();
};

void PointTreeTest::agreesWithBruteForce_data()
{
    QTest::addColumn<bool>("onGrid");
    QTest::newRow("anywhere") << false;
    QTest::newRow("ties") << true;
}

void PointTreeTest::agreesWithBruteForce()
{
    QFETCH(bool, onGrid);
    const std::vector<Vec3> points = randomPoints(700, onGrid);
    const PointTree tree(points);
    for (int q = 0; q < 60; ++q) {
        const Vec3 query = points[std::size_t(q * 11)] + Vec3(0.01, 0.0, 0.003) * (q % 3);
        std::vector<int> expected = sortedByDistance(points, query);
        const double radius = 0.2 * (onGrid ? 5 : 1);
        std::vector<int> inside;
        for (int i : expected)
            if ((points[std::size_t(i)] - query).squaredNorm() <= radius * radius)
                inside.push_back(i);
        std::sort(inside.begin(), inside.end());
        QCOMPARE(tree.within(query, radius), inside);
        expected.resize(17);
        QCOMPARE(tree.nearest(query, 17), expected);
    }
}

void PointTreeTest::smallSets()
{
    QVERIFY(PointTree({}).nearest(Vec3::Zero(), 3).empty());
    QVERIFY(PointTree({}).within(Vec3::Zero(), 1.0).empty());
    const PointTree two({Vec3(1, 0, 0), Vec3(0, 1, 0)});
    QCOMPARE(two.nearest(Vec3(0, 2, 0), 5), (std::vector<int>{1, 0}));
    QVERIFY(two.nearest(Vec3::Zero(), 0).empty());
}

QTEST_APPLESS_MAIN(PointTreeTest)
#include "point_tree_test.moc"
