#include "formats/sketches/point_order.h"

#include "base/random.h"

#include <QtTest>
#include <cmath>

using namespace ductus;

namespace {

/// A spiral on a sphere, as a hand scribbles a surface.
std::vector<Vec3> scribble(int count)
{
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - 2.0 * (i + 0.5) / count, r = std::sqrt(1.0 - z * z), phi = i * 0.11;
        points.emplace_back(r * std::cos(phi), r * std::sin(phi), z);
    }
    return points;
}

std::vector<Vec3> shuffled(std::vector<Vec3> points, std::uint64_t seed)
{
    Random(seed).shuffle(points);
    return points;
}

} // namespace

class PointOrderTest : public QObject
{
    Q_OBJECT
private slots:
    void strokesAreOrdered();
    void shuffledPointsAreNot();
    void repeatedPointsDoNotDeceive();
    void fewOrEqualPointsAreOrdered();
};

void PointOrderTest::strokesAreOrdered()
{
    for (int count : {16, 100, 511, 513, 5000, 100000})
        QVERIFY2(!isUnordered(scribble(count)), std::to_string(count).c_str());
}

void PointOrderTest::shuffledPointsAreNot()
{
    for (int count : {200, 511, 513, 5000, 100000})
        QVERIFY2(isUnordered(shuffled(scribble(count), 3)), std::to_string(count).c_str());
}

void PointOrderTest::repeatedPointsDoNotDeceive()
{
    std::vector<Vec3> doubled, retraced = scribble(300);
    for (const Vec3 &p : scribble(300))
        doubled.insert(doubled.end(), 2, p);
    for (int i = 299; i >= 0; --i)
        retraced.push_back(retraced[std::size_t(i)]);
    QVERIFY(!isUnordered(doubled));
    QVERIFY(!isUnordered(retraced));
    QVERIFY(isUnordered(shuffled(doubled, 4)));
}

void PointOrderTest::fewOrEqualPointsAreOrdered()
{
    QVERIFY(!isUnordered({}));
    QVERIFY(!isUnordered(shuffled(scribble(15), 5)));
    QVERIFY(!isUnordered(std::vector<Vec3>(100, Vec3(1, 2, 3))));
}

QTEST_APPLESS_MAIN(PointOrderTest)
#include "point_order_test.moc"
