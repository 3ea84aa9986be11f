#include "geometry/remesh.h"

#include "geometry/alpha_wrap.h"
#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"
#include "support/mesh_zoo.h"

#include <QtTest>
#include <limits>

using namespace ductus;

namespace {

TriangleMesh remesh(const TriangleMesh &mesh, double length, int iterations = 3, double crease = 0.0)
{
    Result<TriangleMesh> result = remeshed(mesh, {length, iterations, crease}, JobControl());
    return result.ok() ? std::move(*result) : TriangleMesh();
}

int eulerCharacteristic(const TriangleMesh &mesh)
{
    return mesh.vertexCount() - int(MeshTopology(mesh).edges.size()) + mesh.triangleCount();
}

/// Largest distance of the vertices and centroids of \a from to the surface of \a to.
double farthest(const TriangleMesh &from, const TriangleMesh &to)
{
    const NearestOnMesh nearest(to);
    double distance = 0.0;
    for (const Vec3 &v : from.vertices)
        distance = std::max(distance, nearest.nearest(v).distance);
    for (int t = 0; t < from.triangleCount(); ++t)
        distance = std::max(distance, nearest.nearest(from.centroid(t)).distance);
    return distance;
}

double hausdorff(const TriangleMesh &a, const TriangleMesh &b)
{
    return std::max(farthest(a, b), farthest(b, a));
}

/// Shares of edges within 2/3 .. 3/2 of the target length, and of triangles with no angle below 30 degrees.
std::pair<double, double> evenness(const TriangleMesh &mesh, double length)
{
    int even = 0, round = 0;
    const MeshTopology topology(mesh);
    for (const MeshEdge &e : topology.edges) {
        const double share = (mesh.vertices[e.v0] - mesh.vertices[e.v1]).norm() / length;
        even += share > 2.0 / 3.0 && share < 1.5 ? 1 : 0;
    }
    for (const Triangle &t : mesh.triangles) {
        bool good = true;
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = (mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]]).normalized();
            const Vec3 b = (mesh.vertices[t[(k + 2) % 3]] - mesh.vertices[t[k]]).normalized();
            good = good && a.dot(b) < std::cos(std::numbers::pi / 6.0);
        }
        round += good ? 1 : 0;
    }
    return {double(even) / double(topology.edges.size()), double(round) / mesh.triangleCount()};
}

} // namespace

class RemeshTest : public QObject
{
    Q_OBJECT
private slots:
    void spheresBecomeEvenAndStaySpheres();
    void torusKeepsItsHandle();
    void bordersStayWhereTheyAre();
    void creasesAndCornersAreKept();
    void meshCoarserThanTheTargetIsRefinedAndFinerOneThinned();
    void alphaWrapsStayCloseAndManifold();
    void sameInputSameBytes();
    void cancelStopsAndProgressRises();
    void badInputIsRefused();
};

void RemeshTest::spheresBecomeEvenAndStaySpheres()
{
    const TriangleMesh sphere = zoo::icosphere(5);
    for (const double length : {0.05, 0.1, 0.25}) {
        const TriangleMesh mesh = remesh(sphere, length);
        const ManifoldReport report = manifoldReport(mesh);
        QVERIFY(report.isClosed());
        QCOMPARE(report.degenerateTriangles, 0);
        QCOMPARE(eulerCharacteristic(mesh), 2);
        const auto [even, round] = evenness(mesh, length);
        QVERIFY(even > 0.95);
        QVERIFY(round > 0.95);
        // The sagitta of a chord of 4/3 length is the least any mesh with such edges must deviate.
        QVERIFY(hausdorff(mesh, sphere) < 0.1 * length);
        for (int t = 0; t < mesh.triangleCount(); ++t)
            QVERIFY(mesh.faceNormal(t).dot(mesh.centroid(t).normalized()) > 0.9);
        for (const Vec3 &v : mesh.vertices)
            QVERIFY(v.norm() > 0.999 && v.norm() < 1.0 + 1e-12);
    }
}

void RemeshTest::torusKeepsItsHandle()
{
    const TriangleMesh torus = zoo::torus(1.0, 0.35, 96, 40);
    for (const double length : {0.06, 0.15}) {
        const TriangleMesh mesh = remesh(torus, length);
        QVERIFY(manifoldReport(mesh).isClosed());
        QCOMPARE(eulerCharacteristic(mesh), 0);
        QVERIFY(evenness(mesh, length).first > 0.93);
        QVERIFY(hausdorff(mesh, torus) < 0.15 * length);
        QVERIFY(std::abs(signedVolume(mesh) / signedVolume(torus) - 1.0) < 0.05);
    }
}

void RemeshTest::bordersStayWhereTheyAre()
{
    for (const auto &[cells, length] : {std::pair(40, 0.05), std::pair(40, 0.12), std::pair(3, 0.04)}) {
        const TriangleMesh grid = zoo::grid(cells, 0.3);
        const TriangleMesh mesh = remesh(grid, length, 4);
        const ManifoldReport report = manifoldReport(mesh);
        QVERIFY(report.isManifold());
        QCOMPARE(eulerCharacteristic(mesh), 1);
        QVERIFY(hausdorff(mesh, grid) < 0.15 * length);
        QVERIFY(evenness(mesh, length).first > 0.8);
        double around = 0.0;
        int corners = 0;
        for (const MeshEdge &e : MeshTopology(mesh).edges) {
            if (e.faceCount != 1)
                continue;
            const Vec3 &a = mesh.vertices[e.v0], &b = mesh.vertices[e.v1];
            around += (a - b).norm();
            const Vec3 m = 0.5 * (a + b);
            QVERIFY(std::min({m.x(), 1.0 - m.x(), m.y(), 1.0 - m.y()}) < 1e-12);
        }
        QVERIFY(std::abs(around - 4.0) < 1e-9);
        for (const Vec3 &v : mesh.vertices)
            corners += (v.x() == 0.0 || v.x() == 1.0) && (v.y() == 0.0 || v.y() == 1.0) ? 1 : 0;
        QCOMPARE(corners, 4);
    }
}

void RemeshTest::creasesAndCornersAreKept()
{
    const TriangleMesh mesh = remesh(zoo::box({0, 0, 0}, {1, 2, 0.5}), 0.08, 4, 30.0);
    QVERIFY(manifoldReport(mesh).isClosed());
    QVERIFY(std::abs(signedVolume(mesh) - 1.0) < 1e-9);
    QVERIFY(std::abs(surfaceArea(mesh) - 7.0) < 1e-9);
    QVERIFY(evenness(mesh, 0.08).first > 0.9);
}

void RemeshTest::meshCoarserThanTheTargetIsRefinedAndFinerOneThinned()
{
    const TriangleMesh fine = remesh(zoo::icosphere(0), 0.05);
    QVERIFY(manifoldReport(fine).isClosed());
    QVERIFY(evenness(fine, 0.05).first > 0.9);
    QVERIFY(fine.vertexCount() > 3000);

    const TriangleMesh coarse = remesh(zoo::icosphere(5), 10.0);
    QVERIFY(manifoldReport(coarse).isClosed());
    QCOMPARE(eulerCharacteristic(coarse), 2);
    QVERIFY(coarse.vertexCount() < 200);
    QVERIFY(signedVolume(coarse) > 0.0);
}

void RemeshTest::alphaWrapsStayCloseAndManifold()
{
    // Strokes on a wavy sheet: the wrap is two sheets close to each other with sharp ridges around.
    std::vector<Vec3> points;
    for (int k = 0; k < 7; ++k) {
        for (int i = 0; i < 150; ++i) {
            points.push_back({i / 150.0, k / 6.0, 0.2 * std::sin(5.0 * i / 150.0)});
            points.push_back({k / 6.0, i / 150.0, 0.2 * std::sin(5.0 * k / 6.0)});
        }
    }
    for (const double alpha : {0.05, 0.12, 0.4}) {
        const Result<TriangleMesh> wrap = alphaWrap(points, {alpha, 0.02});
        QVERIFY(wrap.ok());
        for (const double length : {0.02, 0.06}) {
            const TriangleMesh mesh = remesh(*wrap, length);
            const ManifoldReport report = manifoldReport(mesh);
            QVERIFY(report.isClosed());
            QCOMPARE(report.degenerateTriangles, 0);
            QCOMPARE(report.components, manifoldReport(*wrap).components);
            QCOMPARE(eulerCharacteristic(mesh), eulerCharacteristic(*wrap));
            QVERIFY(hausdorff(mesh, *wrap) < 0.4 * length);
            QVERIFY(signedVolume(mesh) > 0.75 * signedVolume(*wrap));
        }
    }
}

void RemeshTest::sameInputSameBytes()
{
    const TriangleMesh first = remesh(zoo::torus(), 0.08);
    const TriangleMesh second = remesh(zoo::torus(), 0.08);
    QVERIFY(!first.isEmpty());
    QVERIFY(first.vertices == second.vertices);
    QVERIFY(first.triangles == second.triangles);
}

void RemeshTest::cancelStopsAndProgressRises()
{
    std::atomic<bool> cancel = false;
    std::vector<double> seen;
    const JobControl control(&cancel, [&](double fraction, std::string_view) {
        seen.push_back(fraction);
        cancel = fraction > 0.4;
    });
    const Result<TriangleMesh> result = remeshed(zoo::icosphere(3), {0.1, 4, 0.0}, control);
    QVERIFY(!result);
    QVERIFY(result.error().isCancelled());
    QCOMPARE(seen, (std::vector<double>{0.0, 0.25, 0.5}));
}

void RemeshTest::badInputIsRefused()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto code = [](const TriangleMesh &mesh, const RemeshOptions &options) {
        const Result<TriangleMesh> result = remeshed(mesh, options, JobControl());
        return result.ok() ? -1 : int(result.error().code);
    };
    const int invalid = int(ErrorCode::InvalidArgument);
    for (const RemeshOptions &options : {RemeshOptions{0.0, 3, 0.0},
                                         {-1.0, 3, 0.0},
                                         {nan, 3, 0.0},
                                         {0.1, 0, 0.0},
                                         {0.1, 3, -1.0},
                                         {0.1, 3, nan}})
        QCOMPARE(code(zoo::box(), options), invalid);
    const RemeshOptions good{0.1, 3, 0.0};
    QCOMPARE(code(zoo::box(), {1e-7, 3, 0.0}), int(ErrorCode::TooLarge));
    QCOMPARE(code({}, good), int(ErrorCode::TooLittleData));
    for (const TriangleMesh &mesh :
         {zoo::moebiusStrip(), zoo::tetrahedraSharingEdge(), zoo::tetrahedraSharingVertex()})
        QCOMPARE(code(mesh, good), invalid);
    TriangleMesh mesh = zoo::box();
    mesh.vertices[2].z() = nan;
    QCOMPARE(code(mesh, good), invalid);
    mesh = zoo::box();
    mesh.triangles[2][1] = 8;
    QCOMPARE(code(mesh, good), invalid);
    mesh = zoo::box();
    mesh.triangles.push_back({1, 1, 2});
    QCOMPARE(code(mesh, good), invalid);
}

QTEST_APPLESS_MAIN(RemeshTest)
#include "remesh_test.moc"
