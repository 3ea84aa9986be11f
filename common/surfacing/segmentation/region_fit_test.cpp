#include "surfacing/segmentation/region_fit.h"

#include "base/random.h"

#include <QtTest>
#include <cmath>

using namespace ductus;

namespace {

// The top of a box drawn by its four edges only, over a proxy that rounds them: a normal at an edge leans
// outwards by half a right angle, more on one side than on the other, and the vertices within the face are a
// bulge's.
Association boxTop(double noise)
{
    Random random(3);
    Association a;
    for (int side = 0; side < 4; ++side)
        for (int i = 0; i < 60; ++i) {
            const double t = -0.3 + 0.6 * i / 59.0, z = random.uniform(-noise, noise);
            const double r = side % 2 ? 0.3 : 0.2, lean = side == 0 ? 1.1 : 0.6;
            const Vec3 out = side % 2 ? Vec3(side == 1 ? 1 : -1, 0, 0) : Vec3(0, side == 0 ? 1 : -1, 0);
            const Vec3 along = side % 2 ? Vec3(0, t * 2.0 / 3.0, 0) : Vec3(t, 0, 0);
            a.points.push_back(
                {r * out + along + Vec3(0, 0, z), std::cos(lean) * Vec3::UnitZ() + std::sin(lean) * out});
        }
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        a.vertices.push_back(a.points[i]);
        a.pointsOfVertex.push_back({int(i)});
    }
    for (int i = -5; i <= 5; ++i)
        for (int j = -5; j <= 5; ++j) {
            const Vec3 p(0.05 * i, 0.03 * j, 0.03);
            a.vertices.push_back({p, Vec3(0.8 * p.x(), 0.8 * p.y(), 1.0).normalized()});
            a.pointsOfVertex.emplace_back();
        }
    return a;
}

std::vector<char> everywhere(const Association &a)
{
    return std::vector<char>(a.pointsOfVertex.size(), 1);
}

double rootMeanSquare(const Association &a, const ImplicitPolynomial &model)
{
    double sum = 0.0;
    for (const OrientedPoint &p : a.points)
        sum += std::pow(model.signedDistance(p.point), 2);
    return std::sqrt(sum / double(a.points.size()));
}

} // namespace

class RegionFitTest : public QObject
{
    Q_OBJECT
private slots:
    void directionsComeFromVerticesAwayFromStrokes();
    void flatFaceDrawnByItsOutlineIsAPlane();
    void regionWithoutFreeVerticesBelievesItsPoints();
    void unionHasEachOnce();
};

void RegionFitTest::directionsComeFromVerticesAwayFromStrokes()
{
    const Association a = boxTop(0.0);
    const RegionSupport support = supportOf(a, everywhere(a));
    QCOMPARE(support.points.size(), a.points.size());
    QCOMPARE(support.freeVertices.size(), std::size_t(121));
    for (int v : support.freeVertices)
        QVERIFY(a.pointsOfVertex[std::size_t(v)].empty());
}

void RegionFitTest::flatFaceDrawnByItsOutlineIsAPlane()
{
    const Association a = boxTop(0.004);
    const RegionSupport support = supportOf(a, everywhere(a));
    const double drawn = 0.004 / std::sqrt(3.0);
    const ImplicitPolynomial plane = fitRegion(a, support, 1, {});
    QVERIFY2(rootMeanSquare(a, plane) < 1.1 * drawn, qPrintable(QString::number(rootMeanSquare(a, plane))));
    Vec3 normal;
    plane.signedDistance(Vec3::Zero(), &normal);
    QVERIFY(normal.z() > 0.9999); // tilted by less than a degree, however lopsided the normals
}

void RegionFitTest::regionWithoutFreeVerticesBelievesItsPoints()
{
    const Association a = boxTop(0.001);
    std::vector<char> flags = everywhere(a);
    std::fill(flags.begin() + std::ptrdiff_t(a.points.size()), flags.end(), 0);
    const RegionSupport support = supportOf(a, flags);
    QVERIFY(support.freeVertices.empty());
    Vec3 normal;
    const ImplicitPolynomial model = fitRegion(a, support, 1, {});
    model.signedDistance(Vec3::Zero(), &normal);
    QVERIFY(normal.z() > 0.99);
    QVERIFY(rootMeanSquare(a, model) < 0.01);
}

void RegionFitTest::unionHasEachOnce()
{
    const RegionSupport both = united({{1, 2, 5}, {7}}, {{2, 3}, {6, 7}});
    QCOMPARE(both.points, (std::vector<int>{1, 2, 3, 5}));
    QCOMPARE(both.freeVertices, (std::vector<int>{6, 7}));
}

QTEST_APPLESS_MAIN(RegionFitTest)
#include "region_fit_test.moc"
