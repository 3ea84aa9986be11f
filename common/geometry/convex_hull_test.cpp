#include "geometry/convex_hull.h"

#include <QtTest>

using namespace ductus;

class ConvexHullTest : public QObject
{
    Q_OBJECT

private slots:
    void cubeWithPointsInsideHasItsFaces()
    {
        std::vector<Vec3> points;
        for (int corner = 0; corner < 8; ++corner)
            points.push_back({double(corner & 1), double(corner >> 1 & 1), double(corner >> 2)});
        for (int i = 1; i < 10; ++i)
            points.push_back({0.1 * i, 0.05 * i, 1.0 - 0.1 * i});
        const std::vector<Triangle> triangles = convexHull(points);
        QCOMPARE(triangles.size(), std::size_t(12));
        for (const Triangle &t : triangles)
            for (const int corner : t)
                QVERIFY(corner < 8);
        QVERIFY(std::abs(signedVolume({points, triangles}) - 1.0) < 1e-12);
    }

    void allPointsLieBehindEachTriangle()
    {
        std::vector<Vec3> points;
        for (int i = 0; i < 500; ++i) {
            const double a = 2.39996 * i, z = 1.0 - (2.0 * i + 1.0) / 500;
            const double r = std::sqrt(1.0 - z * z) * (1.0 + 0.1 * (i % 3));
            points.push_back({r * std::cos(a), r * std::sin(a), z});
        }
        const std::vector<Triangle> triangles = convexHull(points);
        QVERIFY(triangles.size() > 100);
        for (const Triangle &t : triangles) {
            const Vec3 &a = points[std::size_t(t[0])], &b = points[std::size_t(t[1])],
                       &c = points[std::size_t(t[2])];
            for (const Vec3 &p : points)
                QVERIFY((b - a).cross(c - a).dot(p - a) < 1e-9);
        }
    }

    void flatPointsHaveNone()
    {
        QVERIFY(convexHull({}).empty());
        QVERIFY(convexHull({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).empty());
        QVERIFY(convexHull({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).empty());
        QVERIFY(convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 0}}).empty());
    }
};

QTEST_GUILESS_MAIN(ConvexHullTest)
#include "convex_hull_test.moc"
