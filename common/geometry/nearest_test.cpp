#include "geometry/nearest.h"

#include "base/parallel.h"
#include "base/random.h"
#include "geometry/triangle_point.h"
#include "support/mesh_zoo.h"

#include <QtTest>

using namespace ductus;

namespace {

Vec3 randomPoint(Random &random, double reach)
{
    const double x = random.uniform(-reach, reach);
    const double y = random.uniform(-reach, reach);
    return {x, y, random.uniform(-reach, reach)};
}

/// Distance by projecting onto the plane and, outside the triangle, onto the three sides: not the code under
/// test.
double plainDistance(const Vec3 &p, const Vec3 &a, const Vec3 &b, const Vec3 &c)
{
    const auto toSegment = [&p](const Vec3 &s, const Vec3 &t) {
        const double along = std::clamp((p - s).dot(t - s) / (t - s).squaredNorm(), 0.0, 1.0);
        return (p - s - along * (t - s)).norm();
    };
    const Vec3 n = (b - a).cross(c - a).normalized();
    const Vec3 foot = p - n * n.dot(p - a);
    const bool within = (b - a).cross(foot - a).dot(n) >= 0.0 && (c - b).cross(foot - b).dot(n) >= 0.0 &&
                        (a - c).cross(foot - c).dot(n) >= 0.0;
    return within ? std::abs(n.dot(p - a)) : std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
}

double bruteForceDistance(const TriangleMesh &mesh, const Vec3 &p)
{
    double best = 1e300;
    for (const Triangle &t : mesh.triangles)
        best =
            std::min(best, plainDistance(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]));
    return best;
}

} // namespace

class NearestTest : public QObject
{
    Q_OBJECT
private slots:
    void distancesMatchBruteForce();
    void resultsAreConsistentInThemselves();
    void trianglesWithoutAreaAreLeftOut();
    void manyThreadsGetTheSameAnswers();
    void insideOfATorusIsKnownExactly();
    void insideIsRightOnRaysThroughEdgesAndCorners();
};

void NearestTest::distancesMatchBruteForce()
{
    Random random(11);
    for (const TriangleMesh &mesh :
         {zoo::icosphere(2), zoo::torus(1.0, 0.35, 24, 10), zoo::grid(7, 0.4), zoo::box()}) {
        const NearestOnMesh nearest(mesh);
        for (int i = 0; i < 500; ++i) {
            const Vec3 p = randomPoint(random, i % 2 ? 3.0 : 1.1);
            QVERIFY(std::abs(nearest.nearest(p).distance - bruteForceDistance(mesh, p)) < 1e-12);
        }
    }
}

void NearestTest::resultsAreConsistentInThemselves()
{
    const TriangleMesh mesh = zoo::torus();
    const NearestOnMesh nearest(mesh);
    Random random(12);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p = i < mesh.vertexCount() ? mesh.vertices[i] : randomPoint(random, 2.0);
        const NearestPoint n = nearest.nearest(p);
        QVERIFY(n.triangle >= 0 && n.triangle < mesh.triangleCount());
        QVERIFY(n.barycentric.minCoeff() >= 0.0);
        QVERIFY(std::abs(n.barycentric.sum() - 1.0) < 1e-14);
        const Triangle &t = mesh.triangles[n.triangle];
        const Vec3 point = n.barycentric[0] * mesh.vertices[t[0]] + n.barycentric[1] * mesh.vertices[t[1]] +
                           n.barycentric[2] * mesh.vertices[t[2]];
        QVERIFY((point - n.point).norm() < 1e-14);
        QVERIFY(std::abs((p - n.point).norm() - n.distance) < 1e-14);
        if (i < mesh.vertexCount())
            QVERIFY(n.distance < 1e-14);
    }
}

void NearestTest::trianglesWithoutAreaAreLeftOut()
{
    TriangleMesh mesh = zoo::grid(1);
    mesh.vertices.push_back({5, 5, 5});
    mesh.triangles.insert(mesh.triangles.begin(), {{4, 4, 4}, {0, 0, 4}});
    const NearestPoint n = NearestOnMesh(mesh).nearest({5, 5, 5});
    QVERIFY(n.triangle >= 2);
    QVERIFY((n.point - Vec3(1, 1, 0)).norm() < 1e-15);
}

void NearestTest::manyThreadsGetTheSameAnswers()
{
    const TriangleMesh mesh = zoo::icosphere(4);
    std::vector<Vec3> queries;
    Random random(13);
    for (int i = 0; i < 4000; ++i)
        queries.push_back(randomPoint(random, 1.5));
    queries.push_back({0, 0, 0}); // equally far from many triangles

    const NearestOnMesh first(mesh);
    NearestOnMesh second(mesh);
    const NearestOnMesh moved(std::move(second));
    std::vector<NearestPoint> parallel(queries.size());
    parallelFor(
        0, queries.size(), [&](std::size_t i) { parallel[i] = first.nearest(queries[i]); }, 64);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const NearestPoint serial = moved.nearest(queries[i]);
        QCOMPARE(parallel[i].triangle, serial.triangle);
        QVERIFY(parallel[i].point == serial.point);
    }
}

void NearestTest::insideOfATorusIsKnownExactly()
{
    const TriangleMesh mesh = zoo::torus(1.0, 0.35, 96, 40);
    const NearestOnMesh nearest(mesh);
    const NearestOnMesh turned(zoo::turnedOver(mesh));
    Random random(14);
    int inside = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 p = randomPoint(random, 1.4);
        const double ring = std::hypot(p.x(), p.y()) - 1.0;
        const double depth = 0.35 - std::hypot(ring, p.z());
        if (std::abs(depth) < 0.01)
            continue; // between the circle and its polygon
        QCOMPARE(nearest.isInside(p), depth > 0.0);
        QVERIFY(!turned.isInside(p));
        inside += depth > 0.0 ? 1 : 0;
    }
    QVERIFY(inside > 100);
}

void NearestTest::insideIsRightOnRaysThroughEdgesAndCorners()
{
    // Corners of the box lie on the ray directions themselves, seen from its centre.
    for (const Vec3 &d : {Vec3(0.5374, 0.6261, 0.5649), Vec3(1, 1, 1), Vec3(0, 0, 1), Vec3(1, 1, 0)}) {
        Vec3 size = d.cwiseMax(0.25);
        const NearestOnMesh nearest(zoo::box(-size, size));
        QVERIFY(nearest.isInside({0, 0, 0}));
        QVERIFY(nearest.isInside(0.5 * size));
        QVERIFY(!nearest.isInside(-1.5 * size));
        QVERIFY(!nearest.isInside({-2.0 * size.x(), 0, 0}));
    }
    // A grid of queries in line with every vertex and edge of a refined box.
    const NearestOnMesh octahedron(TriangleMesh{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}});
    for (int x = -6; x <= 6; ++x)
        for (int y = -6; y <= 6; ++y)
            for (int z = -6; z <= 6; ++z) {
                const int sum = std::abs(x) + std::abs(y) + std::abs(z);
                if (sum != 5)
                    QCOMPARE(octahedron.isInside(Vec3(x, y, z) / 5.0), sum < 5);
            }
}

QTEST_APPLESS_MAIN(NearestTest)
#include "nearest_test.moc"
