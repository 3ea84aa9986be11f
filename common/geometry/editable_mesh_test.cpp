#include "geometry/editable_mesh.h"

#include "base/random.h"
#include "geometry/mesh_topology.h"
#include "support/mesh_zoo.h"

#include <QtTest>

using namespace ductus;

namespace {

int eulerCharacteristic(const TriangleMesh &mesh)
{
    return mesh.vertexCount() - int(MeshTopology(mesh).edges.size()) + mesh.triangleCount();
}

/// Number of border (crease) edges that end at each vertex must be what the mesh says.
bool featureDegreesAreRight(const EditableMesh &mesh)
{
    std::vector<int> degree(mesh.vertexCount(), 0);
    for (int h = 0; h < mesh.halfEdgeCount(); ++h) {
        if (!mesh.halfEdgeIsAlive(h))
            continue;
        const int g = mesh.opposite(h);
        if (g >= 0 && (mesh.opposite(g) != h || mesh.from(g) != mesh.to(h) || mesh.to(g) != mesh.from(h) ||
                       mesh.isFeature(h) != mesh.isFeature(g)))
            return false;
        if (mesh.isFeature(h) && h > g) {
            ++degree[mesh.from(h)];
            ++degree[mesh.to(h)];
        }
    }
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (mesh.vertexIsAlive(v) && degree[v] != mesh.featureDegree(v))
            return false;
    return true;
}

} // namespace

class EditableMeshTest : public QObject
{
    Q_OBJECT
private slots:
    void unchangedMeshComesBack();
    void ringsAreCounterClockwise();
    void creasesAreFound();
    void randomEditsKeepManifoldGenusAndFeatures();
    void tetrahedronCannotShrink();
};

void EditableMeshTest::unchangedMeshComesBack()
{
    for (const TriangleMesh &mesh : {zoo::icosphere(1), zoo::grid(3)}) {
        const TriangleMesh same = EditableMesh(mesh, 0.0).toTriangleMesh();
        QVERIFY(same.vertices == mesh.vertices);
        QVERIFY(same.triangles == mesh.triangles);
    }
}

void EditableMeshTest::ringsAreCounterClockwise()
{
    const TriangleMesh grid = zoo::grid(4);
    const MeshTopology topology(grid);
    const EditableMesh mesh(grid, 0.0);
    const std::vector<char> border = topology.borderVertices();
    for (int v = 0; v < grid.vertexCount(); ++v) {
        std::vector<int> ring;
        mesh.neighbours(v, ring);
        QCOMPARE(mesh.isBorderVertex(v), bool(border[v]));
        QCOMPARE(ring.size(), topology.vertexEdges[v].size());
        for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
            const Vec3 a = grid.vertices[ring[i]] - grid.vertices[v];
            QVERIFY(a.cross(grid.vertices[ring[i + 1]] - grid.vertices[v]).z() > 0.0);
        }
    }
}

void EditableMeshTest::creasesAreFound()
{
    const EditableMesh sharp(zoo::box(), 30.0);
    const EditableMesh smooth(zoo::box(), 0.0);
    for (int v = 0; v < 8; ++v) {
        QCOMPARE(sharp.featureDegree(v), 3);
        QCOMPARE(smooth.featureDegree(v), 0);
    }
    QVERIFY(featureDegreesAreRight(sharp));
    QVERIFY(featureDegreesAreRight(EditableMesh(zoo::grid(3), 0.0)));
}

void EditableMeshTest::randomEditsKeepManifoldGenusAndFeatures()
{
    Random random(41);
    int collapses = 0, flips = 0;
    for (const auto &[start, crease] :
         {std::pair(zoo::icosphere(1), 0.0), std::pair(zoo::torus(1.0, 0.35, 8, 5), 0.0),
          std::pair(zoo::grid(4), 0.0), std::pair(zoo::box(), 30.0), std::pair(zoo::tetrahedron(), 0.0)}) {
        EditableMesh mesh(start, crease);
        for (int i = 0; i < 4000; ++i) {
            const int h = random.index(mesh.halfEdgeCount());
            const int act = random.index(mesh.halfEdgeCount() < 6000 ? 6 : 4);
            if (!mesh.halfEdgeIsAlive(h))
                continue;
            if (act >= 4) {
                mesh.split(h);
            } else if (act >= 2 && mesh.canFlip(h)) {
                mesh.flip(h);
                ++flips;
            } else if (act < 2 && mesh.canCollapse(h)) {
                mesh.collapse(h);
                ++collapses;
            }
            if (i % 50 != 0)
                continue;
            const TriangleMesh now = mesh.toTriangleMesh();
            const ManifoldReport report = manifoldReport(now);
            QVERIFY(report.isManifold());
            QCOMPARE(report.isClosed(), manifoldReport(start).isClosed());
            QCOMPARE(report.components, 1);
            QCOMPARE(eulerCharacteristic(now), eulerCharacteristic(start));
            QVERIFY(featureDegreesAreRight(mesh));
        }
    }
    QVERIFY(collapses > 500);
    QVERIFY(flips > 500);
}

void EditableMeshTest::tetrahedronCannotShrink()
{
    EditableMesh mesh(zoo::tetrahedron(), 0.0);
    for (int h = 0; h < mesh.halfEdgeCount(); ++h) {
        QVERIFY(!mesh.canCollapse(h));
        QVERIFY(!mesh.canFlip(h));
    }
    EditableMesh triangle(TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 0.0);
    for (int h = 0; h < 3; ++h)
        QVERIFY(!triangle.canCollapse(h));
}

QTEST_APPLESS_MAIN(EditableMeshTest)
#include "editable_mesh_test.moc"
