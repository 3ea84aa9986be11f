#include "surfacing/proxy/contour.h"

#include "geometry/mesh_topology.h"

#include <QtTest>
#include <numbers>

using namespace ductus;

namespace {

const Box3 unitBox{Vec3::Constant(-1.0), Vec3::Constant(1.0)};

ScalarField sphere(const Vec3 &centre, double radius)
{
    return [=](const Vec3 &x) { return (x - centre).norm() - radius; };
}

double torus(const Vec3 &x)
{
    return std::hypot(std::hypot(x.x(), x.y()) - 0.6, x.z()) - 0.2;
}

ContourOptions cells(double size)
{
    ContourOptions options;
    options.cellSize = size;
    return options;
}

TriangleMesh contour(const ScalarField &field, const std::vector<Vec3> &seeds, const ContourOptions &options)
{
    Result<TriangleMesh> mesh = contourFromSeeds(field, seeds, unitBox, options, {});
    if (!mesh)
        qFatal("%s", mesh.error().message().c_str());
    return std::move(*mesh);
}

int eulerNumber(const TriangleMesh &mesh)
{
    return mesh.vertexCount() - int(MeshTopology(mesh).edges.size()) + mesh.triangleCount();
}

} // namespace

class ContourTest : public QObject
{
    Q_OBJECT
private slots:
    void sphereIsClosedOutwardsAndOnTheZeroSet();
    void torusHasAHandle();
    void everySeededComponentIsFound();
    void surfaceThatLeavesTheBoxIsOpenThere();
    void zeroAtGridNodesIsNoHole();
    void refinementsBringVerticesNearer();
    void noSurfaceNearTheSeedsGivesAnEmptyMesh();
    void onlyTheNeighbourhoodIsEvaluated();
    void tooManyCellsAreRefused();
    void cancelled();
};

void ContourTest::sphereIsClosedOutwardsAndOnTheZeroSet()
{
    const ScalarField field = sphere({0.03, -0.02, 0.01}, 0.7);
    const TriangleMesh mesh = contour(field, {{0.7, 0, 0}}, cells(0.07));
    QVERIFY(manifoldReport(mesh).isClosed());
    QCOMPARE(eulerNumber(mesh), 2);
    for (const Vec3 &p : mesh.vertices)
        QVERIFY2(std::abs(field(p)) < 0.01 * 0.07, qPrintable(QString::number(field(p))));
    const double volume = 4.0 / 3.0 * std::numbers::pi * 0.343;
    QVERIFY(signedVolume(mesh) > 0.98 * volume && signedVolume(mesh) < volume);
    for (int t = 0; t < mesh.triangleCount(); ++t)
        QVERIFY(mesh.areaVector(t).dot(mesh.centroid(t) - Vec3(0.03, -0.02, 0.01)) >= 0.0);
}

void ContourTest::torusHasAHandle()
{
    const TriangleMesh mesh = contour(torus, {{0.8, 0, 0}}, cells(0.06));
    const ManifoldReport report = manifoldReport(mesh);
    QVERIFY(report.isClosed());
    QCOMPARE(report.components, 1);
    QCOMPARE(eulerNumber(mesh), 0);
    const double volume = 2.0 * std::numbers::pi * std::numbers::pi * 0.6 * 0.04;
    QVERIFY(std::abs(signedVolume(mesh) / volume - 1.0) < 0.04);
}

void ContourTest::everySeededComponentIsFound()
{
    const Vec3 left(-0.5, 0, 0), right(0.5, 0.1, 0);
    const ScalarField both = [&](const Vec3 &x) {
        return std::min(sphere(left, 0.3)(x), sphere(right, 0.2)(x));
    };
    const TriangleMesh two = contour(both, {{-0.5, 0.3, 0}, {0.5, 0.3, 0}}, cells(0.05));
    QVERIFY(manifoldReport(two).isClosed());
    QCOMPARE(manifoldReport(two).components, 2);
    const TriangleMesh one = contour(both, {{-0.5, 0.3, 0}}, cells(0.05));
    QCOMPARE(manifoldReport(one).components, 1);
    for (const Vec3 &p : one.vertices)
        QVERIFY(p.x() < 0.0);
}

void ContourTest::surfaceThatLeavesTheBoxIsOpenThere()
{
    const TriangleMesh mesh = contour(sphere({0, 0, 1.0}, 0.613), {{0, 0, 0.387}}, cells(0.0501));
    const ManifoldReport report = manifoldReport(mesh);
    QVERIFY(report.isManifold());
    QVERIFY(report.borderEdges > 0);
    QCOMPARE(report.components, 1);
    QCOMPARE(eulerNumber(mesh), 1); // a disk
    const std::vector<char> border = MeshTopology(mesh).borderVertices();
    for (std::size_t v = 0; v < border.size(); ++v) {
        QVERIFY(mesh.vertices[v].z() < 1.0 + 0.0501);
        if (border[v])
            QVERIFY(mesh.vertices[v].z() > 1.0 - 0.0501);
    }
}

void ContourTest::zeroAtGridNodesIsNoHole()
{
    // Corners of the diamond and whole faces of the cube fall exactly on grid nodes.
    const ScalarField diamond = [](const Vec3 &x) { return x.cwiseAbs().sum() - 0.5; };
    const ScalarField cube = [](const Vec3 &x) { return x.cwiseAbs().maxCoeff() - 0.5; };
    for (const ScalarField &field : {diamond, cube}) {
        const TriangleMesh mesh = contour(field, {{0.5, 0, 0}}, cells(0.125));
        QVERIFY(manifoldReport(mesh).borderEdges == 0);
        QVERIFY(manifoldReport(mesh).isManifold());
        QCOMPARE(eulerNumber(mesh), 2);
        for (const Vec3 &p : mesh.vertices)
            QVERIFY(p.allFinite() && std::abs(field(p)) < 1e-9);
    }
}

void ContourTest::refinementsBringVerticesNearer()
{
    const ScalarField steep = [](const Vec3 &x) { return std::pow(x.norm(), 6) - std::pow(0.6, 6); };
    double worst[3];
    for (int steps : {0, 2, 8}) {
        ContourOptions options = cells(0.1);
        options.edgeRefinements = steps;
        double &w = worst[steps == 0 ? 0 : steps == 2 ? 1 : 2];
        w = 0.0;
        for (const Vec3 &p : contour(steep, {{0.6, 0, 0}}, options).vertices)
            w = std::max(w, std::abs(p.norm() - 0.6));
    }
    QVERIFY(worst[1] < 0.5 * worst[0]);
    QVERIFY(worst[2] < 0.1 * worst[1]);
}

void ContourTest::noSurfaceNearTheSeedsGivesAnEmptyMesh()
{
    QVERIFY(contour(sphere(Vec3::Zero(), 0.3), {{0.9, 0.9, 0.9}}, cells(0.05)).isEmpty());
    QVERIFY(contour(sphere(Vec3::Zero(), 0.3), {}, cells(0.05)).isEmpty());
    QVERIFY(contour(sphere(Vec3::Zero(), 0.3), {{5, 5, 5}}, cells(0.05)).isEmpty()); // outside the box
}

void ContourTest::onlyTheNeighbourhoodIsEvaluated()
{
    std::atomic<int> evaluations = 0;
    const ScalarField counted = [&](const Vec3 &x) {
        ++evaluations;
        return x.norm() - 0.7;
    };
    const TriangleMesh mesh = contour(counted, {{0.7, 0, 0}}, cells(0.02));
    QVERIFY(manifoldReport(mesh).isClosed());
    QVERIFY2(evaluations < 101 * 101 * 101 / 4, qPrintable(QString::number(evaluations)));
}

void ContourTest::tooManyCellsAreRefused()
{
    ContourOptions options = cells(0.02);
    options.maxCells = 1000;
    const auto mesh = contourFromSeeds(sphere(Vec3::Zero(), 0.7), {{0.7, 0, 0}}, unitBox, options, {});
    QVERIFY(!mesh.ok());
    QCOMPARE(mesh.error().code, ErrorCode::TooLarge);
    const auto fine = contourFromSeeds(sphere(Vec3::Zero(), 0.7), {{0.7, 0, 0}}, unitBox, cells(1e-6), {});
    QVERIFY(!fine.ok());
    QCOMPARE(fine.error().code, ErrorCode::TooLarge);
}

void ContourTest::cancelled()
{
    const std::atomic<bool> cancel = true;
    const auto mesh = contourFromSeeds(sphere(Vec3::Zero(), 0.7), {{0.7, 0, 0}}, unitBox, cells(0.05),
                                       JobControl(&cancel, {}));
    QVERIFY(!mesh.ok());
    QVERIFY(mesh.error().isCancelled());
}

QTEST_APPLESS_MAIN(ContourTest)
#include "contour_test.moc"
