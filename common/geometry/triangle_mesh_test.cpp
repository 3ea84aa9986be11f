#include "geometry/triangle_mesh.h"
#include "support/mesh_zoo.h"

#include <QtTest>

using namespace ductus;

class TriangleMeshTest : public QObject
{
    Q_OBJECT
private slots:
    void boxHasKnownAreaAndVolume();
    void turningOverNegatesTheVolume();
    void sphereNormalsPointOutwards();
    void isolatedVerticesHaveNoNormalAndAreCompactedAway();
    void emptyMeshesAndBoxesAreHarmless();
};

void TriangleMeshTest::boxHasKnownAreaAndVolume()
{
    const TriangleMesh box = zoo::box({-1, 0, 2}, {1, 3, 6});
    QVERIFY(std::abs(surfaceArea(box) - 2.0 * (2 * 3 + 3 * 4 + 4 * 2)) < 1e-12);
    QVERIFY(std::abs(signedVolume(box) - 24.0) < 1e-12);
    const Box3 bounds = boundingBox(box.vertices);
    QCOMPARE(bounds.min, Vec3(-1, 0, 2));
    QCOMPARE(bounds.max, Vec3(1, 3, 6));
    QVERIFY(std::abs(bounds.diagonal() - std::sqrt(29.0)) < 1e-12);
    for (int t = 0; t < box.triangleCount(); ++t)
        QVERIFY(box.faceNormal(t).dot(box.centroid(t) - bounds.centre()) > 0.0);
}

void TriangleMeshTest::turningOverNegatesTheVolume()
{
    const TriangleMesh sphere = zoo::icosphere(4);
    QVERIFY(std::abs(signedVolume(sphere) - 4.0 / 3.0 * std::numbers::pi) < 0.02);
    QVERIFY(std::abs(signedVolume(sphere) + signedVolume(zoo::turnedOver(sphere))) < 1e-12);
    QVERIFY(std::abs(surfaceArea(sphere) - 4.0 * std::numbers::pi) < 0.02);
}

void TriangleMeshTest::sphereNormalsPointOutwards()
{
    const TriangleMesh sphere = zoo::icosphere(3);
    const std::vector<Vec3> normals = vertexNormals(sphere);
    for (int v = 0; v < sphere.vertexCount(); ++v) {
        QVERIFY(std::abs(normals[v].norm() - 1.0) < 1e-12);
        QVERIFY(normals[v].dot(sphere.vertices[v]) > 0.999);
    }
}

void TriangleMeshTest::isolatedVerticesHaveNoNormalAndAreCompactedAway()
{
    TriangleMesh mesh = zoo::tetrahedron();
    mesh.vertices.insert(mesh.vertices.begin() + 1, Vec3(9, 9, 9));
    for (Triangle &t : mesh.triangles)
        for (int &v : t)
            v += v >= 1 ? 1 : 0;
    QCOMPARE(vertexNormals(mesh)[1], Vec3(0, 0, 0));
    std::vector<int> oldFromNew{7};
    const TriangleMesh smaller = compacted(mesh, &oldFromNew);
    QCOMPARE(oldFromNew, (std::vector<int>{0, 2, 3, 4}));
    QCOMPARE(smaller.vertices, zoo::tetrahedron().vertices);
    QCOMPARE(smaller.triangles, zoo::tetrahedron().triangles);
}

void TriangleMeshTest::emptyMeshesAndBoxesAreHarmless()
{
    QVERIFY(boundingBox({}).isEmpty());
    QCOMPARE(boundingBox({}).diagonal(), 0.0);
    QCOMPARE(meanEdgeLength({}), 0.0);
    QCOMPARE(surfaceArea({}), 0.0);
    QVERIFY(std::abs(meanEdgeLength(zoo::box()) - (2.0 + std::sqrt(2.0)) / 3.0) < 1e-12);
}

QTEST_APPLESS_MAIN(TriangleMeshTest)
#include "triangle_mesh_test.moc"
