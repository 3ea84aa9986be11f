#include "surfacing/parts/tube.h"

#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"
#include "surfacing/parts/centre_line.h"

#include <QtTest>
#include <cmath>
#include <numbers>

using namespace ductus;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 0.1;

TriangleMesh tube(const std::vector<Vec3> &points, const TubeOptions &options = {})
{
    const Result<TriangleMesh> mesh = sweptTube(points, std::vector<double>(points.size(), radius), options);
    return mesh ? *mesh : TriangleMesh();
}

std::vector<Vec3> arc(double bendRadius, double fromAngle, double toAngle, int count = 200)
{
    std::vector<Vec3> points;
    for (int i = 0; i <= count; ++i) {
        const double a = fromAngle + (toAngle - fromAngle) * i / count;
        points.emplace_back(bendRadius * std::cos(a), bendRadius * std::sin(a), 0.0);
    }
    return points;
}

Vec3 nearestOnLine(const std::vector<CentreLine> &lines, const Vec3 &p)
{
    Vec3 best = lines.front().points.front();
    for (const CentreLine &line : lines)
        for (int i = 0; i < line.size(); ++i) {
            const Vec3 &a = line.points[std::size_t(i)], &b = line.points[std::size_t((i + 1) % line.size())];
            if (i + 1 == line.size() && !line.isLoop)
                break;
            const double f = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
            const Vec3 q = a + f * (b - a);
            if ((q - p).norm() < (best - p).norm())
                best = q;
        }
    return best;
}

// Triangles that look towards the line they go around.
int invertedTriangles(const TriangleMesh &mesh, const std::vector<Vec3> &points,
                      const TubeOptions &options = {})
{
    const auto lines = centreLines(points, std::vector<double>(points.size(), radius), options);
    int inverted = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Vec3 out = mesh.centroid(t) - nearestOnLine(lines, mesh.centroid(t));
        if (out.norm() > 1e-9 && mesh.faceNormal(t).dot(out.normalized()) < -0.05)
            ++inverted;
    }
    return inverted;
}

// Edges where the surface folds over: an inverted triangle has three. Unlike the distance from the line it
// also tells where two legs of a bend reach into each other.
int foldedEdges(const TriangleMesh &mesh)
{
    int folded = 0;
    for (const MeshEdge &e : MeshTopology(mesh).edges)
        if (mesh.faceNormal(e.faces[0]).dot(mesh.faceNormal(e.faces[1])) < -0.1)
            ++folded;
    return folded;
}

} // namespace

class TubeTest : public QObject
{
    Q_OBJECT
private slots:
    void straightRound();
    void straightFlat();
    void twoPoints();
    void bendKeepsItsSection();
    void closedLoopIsATorus();
    void loopOutOfPlaneCloses();
    void tightBends_data();
    void tightBends();
    void retracedLineStaysWatertight();
    void radiiFollowThePoints();
    void refusesWhatHasNoLength();
    void longLineIsBounded();
};

void TubeTest::straightRound()
{
    const TriangleMesh mesh = tube({{0, 0, 0}, {0.3, 0, 0}, {2, 0, 0}});
    const ManifoldReport report = manifoldReport(mesh);
    QVERIFY(report.isClosed());
    QCOMPARE(report.components, 1);
    QCOMPARE(report.degenerateTriangles, 0);
    const Box3 box = boundingBox(mesh.vertices);
    QVERIFY(std::abs(box.min.x() + radius) < 1e-9 && std::abs(box.max.x() - 2 - radius) < 1e-9);
    // A prism of 12 sides has 95.5 % of the volume of its cylinder.
    const double round = pi * radius * radius * 2.0 + 4.0 / 3.0 * pi * std::pow(radius, 3);
    QVERIFY(signedVolume(mesh) > 0.92 * round && signedVolume(mesh) < round);
}

void TubeTest::straightFlat()
{
    TubeOptions options;
    options.ends = TubeEnds::Flat;
    const TriangleMesh mesh = tube({{0, 0, 0}, {0, 0, 1}}, options);
    QVERIFY(manifoldReport(mesh).isClosed());
    const Box3 box = boundingBox(mesh.vertices);
    QVERIFY(std::abs(box.min.z()) < 1e-12 && std::abs(box.max.z() - 1.0) < 1e-12);
    const double section = 0.5 * options.sides * radius * radius * std::sin(2 * pi / options.sides);
    QVERIFY(std::abs(signedVolume(mesh) - section) < 1e-9);
}

void TubeTest::twoPoints()
{
    for (double length : {1e-6, 0.01, 0.1, 5.0}) {
        const std::vector<Vec3> line{{1, 2, 3}, Vec3(1, 2, 3) + length * Vec3(1, 1, 0).normalized()};
        const TriangleMesh mesh = tube(line);
        QVERIFY(manifoldReport(mesh).isClosed());
        QVERIFY(signedVolume(mesh) > 3.0 * std::pow(radius, 3)); // of a ball with so few sides
        QCOMPARE(invertedTriangles(mesh, line), 0);
    }
}

void TubeTest::bendKeepsItsSection()
{
    const std::vector<Vec3> bend = arc(1.0, 0.0, pi);
    const TriangleMesh mesh = tube(bend);
    QVERIFY(manifoldReport(mesh).isClosed());
    QCOMPARE(invertedTriangles(mesh, bend), 0);
    for (const Vec3 &v : mesh.vertices)
        if (v.y() > 0.0) {
            const Vec3 flat(v.x(), v.y(), 0);
            QVERIFY(std::abs((v - flat.normalized()).norm() - radius) < 0.01 * radius);
        }
}

void TubeTest::closedLoopIsATorus()
{
    const std::vector<Vec3> circle = arc(1.0, 0.0, 2 * pi - 0.05); // ends do not quite meet
    const TriangleMesh mesh = tube(circle);
    QVERIFY(manifoldReport(mesh).isClosed());
    QCOMPARE(mesh.vertexCount() - 3 * mesh.triangleCount() / 2 + mesh.triangleCount(), 0); // Euler: a torus
    QCOMPARE(invertedTriangles(mesh, circle), 0);
    // Two full turns of a small circle would be a coil, not a ring: too short for its thickness.
    const TriangleMesh ball = tube(arc(0.05, 0.0, 2 * pi));
    QCOMPARE(ball.vertexCount() - ball.triangleCount() / 2, 2 * manifoldReport(ball).components);
}

void TubeTest::loopOutOfPlaneCloses()
{
    std::vector<Vec3> loop;
    for (int i = 0; i <= 300; ++i) {
        const double a = 2 * pi * i / 300;
        loop.emplace_back(std::cos(a), std::sin(a), 0.6 * std::sin(2 * a + 0.4));
    }
    const TriangleMesh mesh = tube(loop);
    QVERIFY(manifoldReport(mesh).isClosed());
    QCOMPARE(invertedTriangles(mesh, loop), 0);
    // The frame has no jump where the loop closes: no edge is much longer than the others.
    double longest = 0.0;
    for (const MeshEdge &e : MeshTopology(mesh).edges)
        longest =
            std::max(longest, (mesh.vertices[std::size_t(e.v0)] - mesh.vertices[std::size_t(e.v1)]).norm());
    QVERIFY(longest < 1.6 * radius);
}

void TubeTest::tightBends_data()
{
    QTest::addColumn<QVector<QVector<double>>>("line");
    QTest::addRow("corner") << QVector<QVector<double>>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    QTest::addRow("sharp corner") << QVector<QVector<double>>{{0, 0, 0}, {1, 0, 0}, {0.2, 0.3, 0}};
    QTest::addRow("hairpin") << QVector<QVector<double>>{{0, 0, 0}, {1, 0, 0}, {1, 0.02, 0}, {0, 0.02, 0}};
    QTest::addRow("zigzag") << QVector<QVector<double>>{{0, 0, 0},     {0.1, 0.1, 0}, {0.2, 0, 0},
                                                        {0.3, 0.1, 0}, {0.4, 0, 0},   {0.5, 0.1, 0.1}};
    QVector<QVector<double>> coil, bend;
    for (int i = 0; i <= 400; ++i)
        coil.push_back({0.05 * std::cos(0.1 * i), 0.05 * std::sin(0.1 * i), 0.001 * i});
    QTest::addRow("coil thinner than the tube") << coil;
    bend.push_back({0.04, -1, 0});
    for (const Vec3 &p : arc(0.04, 0.0, pi, 30))
        bend.push_back({p.x(), p.y(), p.z()});
    bend.push_back({-0.04, -1, 0});
    QTest::addRow("bend of less than the radius") << bend;
}

void TubeTest::tightBends()
{
    QFETCH(QVector<QVector<double>>, line);
    std::vector<Vec3> points;
    for (const auto &p : line)
        points.emplace_back(p[0], p[1], p[2]);
    const TriangleMesh mesh = tube(points);
    const ManifoldReport report = manifoldReport(mesh);
    QVERIFY(report.isClosed());
    QCOMPARE(report.degenerateTriangles, 0);
    QVERIFY(signedVolume(mesh) > 0.0);
    QCOMPARE(foldedEdges(mesh), 0);
    // And it still follows the stroke.
    const NearestOnMesh nearest(mesh);
    for (const Vec3 &p : points)
        QVERIFY(nearest.nearest(p).distance < 1.6 * radius);
}

void TubeTest::retracedLineStaysWatertight()
{
    const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}};
    const TriangleMesh mesh = tube(line);
    QVERIFY(manifoldReport(mesh).isClosed());
    QVERIFY(manifoldReport(mesh).components >= 2);
    QCOMPARE(foldedEdges(mesh), 0);
    QVERIFY(signedVolume(mesh) > 0.0);
}

void TubeTest::radiiFollowThePoints()
{
    const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const Result<TriangleMesh> mesh = sweptTube(line, {0.05, 0.1, 0.2});
    QVERIFY(mesh.ok());
    QVERIFY(manifoldReport(*mesh).isClosed());
    for (const Vec3 &v : mesh->vertices) {
        const double r = std::hypot(v.y(), v.z());
        const double x = v.x();
        if (x < 0.0 || x > 2.0 || r == 0.0)
            continue;
        const double wanted = x < 1.0 ? 0.05 + 0.05 * x : 0.1 + 0.1 * (x - 1.0);
        QVERIFY(std::abs(r - wanted) < 0.005);
    }
}

void TubeTest::refusesWhatHasNoLength()
{
    const auto code = [](const std::vector<Vec3> &points, double r) {
        const Result<TriangleMesh> mesh = sweptTube(points, std::vector<double>(points.size(), r));
        return mesh ? -1 : int(mesh.error().code);
    };
    QCOMPARE(code({}, radius), int(ErrorCode::TooLittleData));
    QCOMPARE(code({{1, 1, 1}}, radius), int(ErrorCode::TooLittleData));
    QCOMPARE(code({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, radius), int(ErrorCode::TooLittleData));
    QCOMPARE(code({{0, 0, 0}, {1, 0, 0}}, 0.0), int(ErrorCode::InvalidArgument));
    QCOMPARE(code({{0, 0, 0}, {std::nan(""), 0, 0}}, radius), int(ErrorCode::InvalidArgument));
}

void TubeTest::longLineIsBounded()
{
    const std::vector<Vec3> line{{0, 0, 0}, {1e6, 0, 0}};
    const TriangleMesh mesh = tube(line);
    QVERIFY(manifoldReport(mesh).isClosed());
    QVERIFY(mesh.vertexCount() <= (TubeOptions().mostSections + 8) * TubeOptions().sides);
}

QTEST_APPLESS_MAIN(TubeTest)
#include "tube_test.moc"
