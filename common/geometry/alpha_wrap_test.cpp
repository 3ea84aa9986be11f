#include "geometry/alpha_wrap.h"

#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"
#include "support/mesh_zoo.h"

#include <QtTest>
#include <limits>

using namespace ductus;

namespace {

/// Rings and meridians of a sphere, as strokes drawn on it.
std::vector<Vec3> strokesOnSphere()
{
    std::vector<Vec3> points;
    for (int k = 0; k < 5; ++k) {
        for (int i = 0; i < 120; ++i) {
            const double u = 2.0 * std::numbers::pi * i / 120;
            const double v = std::numbers::pi * k / 5;
            points.push_back({std::cos(u) * std::cos(v), std::cos(u) * std::sin(v), std::sin(u)});
            points.push_back(
                {std::cos(u) * std::sin(v + 0.3), std::sin(u) * std::sin(v + 0.3), std::cos(v + 0.3)});
        }
    }
    return points;
}

} // namespace

class AlphaWrapTest : public QObject
{
    Q_OBJECT
private slots:
    void wrapsStrokesIntoAClosedSolid();
    void sameInputSameBytes();
    void wrapsOnePointALineAndAPlane();
    void refusesBadInput();
};

void AlphaWrapTest::wrapsStrokesIntoAClosedSolid()
{
    const std::vector<Vec3> points = strokesOnSphere();
    for (const double alpha : {0.15, 0.5, 1.5}) {
        const double offset = 0.03;
        const Result<TriangleMesh> wrap = alphaWrap(points, {alpha, offset});
        QVERIFY(wrap.ok());
        QVERIFY(manifoldReport(*wrap).isClosed());
        QCOMPARE(manifoldReport(*wrap).degenerateTriangles, 0);
        QVERIFY(signedVolume(*wrap) > 0.0);
        const NearestOnMesh nearest(*wrap);
        for (const Vec3 &p : points) {
            QVERIFY(nearest.isInside(p));
            QVERIFY(nearest.nearest(p).distance > 0.0);
        }
        for (const Vec3 &v : wrap->vertices) // no vertex strays from what it wraps
            QVERIFY(std::any_of(points.begin(), points.end(),
                                [&](const Vec3 &p) { return (p - v).norm() < offset + alpha; }));
    }
    // A coarse alpha cannot enter the ball between its strokes.
    const Result<TriangleMesh> coarse = alphaWrap(points, {1.5, 0.03});
    QVERIFY(coarse.ok());
    QVERIFY(signedVolume(*coarse) > 0.7 * 4.0 / 3.0 * std::numbers::pi);
}

void AlphaWrapTest::sameInputSameBytes()
{
    const Result<TriangleMesh> first = alphaWrap(strokesOnSphere(), {0.3, 0.03});
    const Result<TriangleMesh> second = alphaWrap(strokesOnSphere(), {0.3, 0.03});
    QVERIFY(first.ok() && second.ok());
    QVERIFY(first->vertices == second->vertices);
    QVERIFY(first->triangles == second->triangles);
}

void AlphaWrapTest::wrapsOnePointALineAndAPlane()
{
    std::vector<Vec3> line, plane;
    for (int i = 0; i <= 50; ++i) {
        line.push_back({i / 50.0, 0, 0});
        for (int j = 0; j <= 50; ++j)
            plane.push_back({i / 50.0, j / 50.0, 0});
    }
    for (const std::vector<Vec3> &points :
         {std::vector<Vec3>{{1, 2, 3}}, std::vector<Vec3>(5, Vec3(1, 2, 3)), line, plane}) {
        const Result<TriangleMesh> wrap = alphaWrap(points, {0.1, 0.05});
        QVERIFY(wrap.ok());
        QVERIFY(manifoldReport(*wrap).isClosed());
        const NearestOnMesh nearest(*wrap);
        for (const Vec3 &p : points)
            QVERIFY(nearest.isInside(p));
    }
}

void AlphaWrapTest::refusesBadInput()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}};
    for (const AlphaWrapOptions &options :
         {AlphaWrapOptions{0.0, 0.1}, {0.1, 0.0}, {-1.0, 0.1}, {nan, 0.1}, {1e-9, 0.1}}) {
        const Result<TriangleMesh> wrap = alphaWrap(points, options);
        QVERIFY(!wrap);
        QCOMPARE(wrap.error().code, ErrorCode::InvalidArgument);
    }
    QCOMPARE(alphaWrap({}, {0.1, 0.1}).error().code, ErrorCode::TooLittleData);
    QCOMPARE(alphaWrap({{0, nan, 0}}, {0.1, 0.1}).error().code, ErrorCode::Malformed);
}

QTEST_APPLESS_MAIN(AlphaWrapTest)
#include "alpha_wrap_test.moc"
