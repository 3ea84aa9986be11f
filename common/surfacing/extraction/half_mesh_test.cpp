#include "surfacing/extraction/half_mesh.h"

#include "support/mesh_zoo.h"

#include <QtTest>

using namespace ductus;

namespace {

const SymmetryPlane oblique{Vec3(2, -1, 2) / 3.0, 0.13};

bool isBorderExactlyInPlane(const TriangleMesh &half, const SymmetryPlane &plane)
{
    const std::vector<char> border = MeshTopology(half).borderVertices();
    for (std::size_t v = 0; v < border.size(); ++v) {
        const double distance = plane.signedDistance(half.vertices[v]);
        if (border[v] ? std::abs(distance) > 1e-14 : distance < -1e-14)
            return false;
    }
    return true;
}

} // namespace

class HalfMeshTest : public QObject
{
    Q_OBJECT
private slots:
    void cutsAlongThePlaneExactly();
    void halvesMakeAWhole();
    void verticesInThePlaneMakeNoFlaps();
    void meshOnTheKeptSideStaysWhole();
    void flagsOnlyBorderVerticesInThePlane();
    void weldsToAClosedSymmetricMesh();
    void otherBordersStayOpen();
};

void HalfMeshTest::cutsAlongThePlaneExactly()
{
    for (const TriangleMesh &mesh : {zoo::icosphere(3), zoo::torus()}) {
        const TriangleMesh half = keptHalf(mesh, oblique);
        const ManifoldReport report = manifoldReport(half);
        QVERIFY(report.isManifold());
        QVERIFY(report.borderEdges > 0);
        QVERIFY(isBorderExactlyInPlane(half, oblique));
    }
}

void HalfMeshTest::halvesMakeAWhole()
{
    const TriangleMesh mesh = zoo::icosphere(4);
    const SymmetryPlane other{-oblique.normal, -oblique.offset};
    const double area = surfaceArea(keptHalf(mesh, oblique)) + surfaceArea(keptHalf(mesh, other));
    QVERIFY2(std::abs(area / surfaceArea(mesh) - 1.0) < 2e-3, qPrintable(QString::number(area)));
    // A cap of the unit sphere has the area 2 pi h.
    const double cap = 2.0 * std::numbers::pi * (1.0 - oblique.offset);
    QVERIFY(std::abs(surfaceArea(keptHalf(mesh, oblique)) / cap - 1.0) < 5e-3);
}

void HalfMeshTest::verticesInThePlaneMakeNoFlaps()
{
    // The icosphere has whole rings of vertices exactly in the coordinate planes.
    for (int axis = 0; axis < 3; ++axis) {
        const SymmetryPlane plane{Vec3::Unit(axis), 0.0};
        const TriangleMesh mesh = zoo::icosphere(2);
        const TriangleMesh half = keptHalf(mesh, plane);
        for (const Triangle &t : half.triangles) {
            double farthest = 0.0;
            for (int v : t)
                farthest = std::max(farthest, plane.signedDistance(half.vertices[v]));
            QVERIFY2(farthest > 1e-9, "a triangle lies in the mirror plane");
        }
        QVERIFY(std::abs(surfaceArea(half) / surfaceArea(mesh) - 0.5) < 1e-9);
        QVERIFY(isBorderExactlyInPlane(half, plane));
    }
}

void HalfMeshTest::meshOnTheKeptSideStaysWhole()
{
    const TriangleMesh mesh = zoo::icosphere(2);
    const TriangleMesh half = keptHalf(mesh, {Vec3::UnitX(), -2.0});
    QCOMPARE(half.triangleCount(), mesh.triangleCount());
    QVERIFY(keptHalf(mesh, {Vec3::UnitX(), 2.0}).isEmpty());
}

void HalfMeshTest::flagsOnlyBorderVerticesInThePlane()
{
    const TriangleMesh mesh = zoo::grid(4); // border all around; vertices at x = 0.5 inside
    const std::vector<char> side = verticesInPlane(mesh, {Vec3::UnitX(), 0.0});
    QCOMPARE(std::count(side.begin(), side.end(), 1), 5);
    for (std::size_t v = 0; v < side.size(); ++v)
        QCOMPARE(bool(side[v]), mesh.vertices[v].x() == 0.0);
    const std::vector<char> middle = verticesInPlane(mesh, {Vec3::UnitX(), 0.5});
    QCOMPARE(std::count(middle.begin(), middle.end(), 1), 2); // only where it meets the border
}

void HalfMeshTest::weldsToAClosedSymmetricMesh()
{
    const TriangleMesh half = keptHalf(zoo::torus(), oblique);
    const std::vector<char> inPlane = verticesInPlane(half, oblique);
    const MirroredMesh whole = withMirrorImage(half, oblique, inPlane);
    QVERIFY(manifoldReport(whole.mesh).isClosed());
    QVERIFY(signedVolume(whole.mesh) > 0.0);
    QVERIFY(std::abs(surfaceArea(whole.mesh) - 2.0 * surfaceArea(half)) < 1e-9);
    QCOMPARE(whole.imageOfVertex.size(), half.vertices.size());
    for (std::size_t v = 0; v < half.vertices.size(); ++v) {
        const int image = whole.imageOfVertex[v];
        QCOMPARE(image == int(v), bool(inPlane[v]));
        QVERIFY((whole.mesh.vertices[image] - oblique.mirrored(whole.mesh.vertices[v])).norm() < 1e-14);
        if (!inPlane[v])
            QCOMPARE(whole.mesh.vertices[v], half.vertices[v]);
    }
}

void HalfMeshTest::otherBordersStayOpen()
{
    const TriangleMesh sheet = zoo::grid(6, 0.2); // only the border at x = 0 is welded
    const SymmetryPlane plane{Vec3::UnitX(), 0.0};
    const MirroredMesh whole = withMirrorImage(sheet, plane, verticesInPlane(sheet, plane));
    const ManifoldReport report = manifoldReport(whole.mesh);
    QVERIFY(report.isManifold());
    QCOMPARE(report.borderEdges, 2 * 3 * 6);
    QCOMPARE(report.components, 1);
    QCOMPARE(whole.mesh.vertexCount(), 2 * 49 - 7);
}

QTEST_APPLESS_MAIN(HalfMeshTest)
#include "half_mesh_test.moc"
