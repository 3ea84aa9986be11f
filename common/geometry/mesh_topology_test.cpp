#include "geometry/mesh_topology.h"
#include "support/mesh_zoo.h"

#include <QtTest>
#include <set>

using namespace ductus;

class MeshTopologyTest : public QObject
{
    Q_OBJECT
private slots:
    void tablesAgreeWithTheTriangles();
    void closedSurfacesHaveTheirEulerCharacteristic();
    void gridHasOneBorderAroundIt();
    void reportSeesEachKindOfDefect();
    void componentsAreNumberedByFirstTriangle();
    void triangleWithARepeatedCornerIsOnlyCounted();
};

void MeshTopologyTest::tablesAgreeWithTheTriangles()
{
    for (const TriangleMesh &mesh :
         {zoo::icosphere(2), zoo::grid(5), zoo::tetrahedraSharingEdge(), zoo::box()}) {
        const MeshTopology topology(mesh);
        std::set<std::pair<int, int>> pairs;
        for (const Triangle &t : mesh.triangles)
            for (int k = 0; k < 3; ++k)
                pairs.insert(std::minmax(t[k], t[(k + 1) % 3]));
        QCOMPARE(topology.edges.size(), pairs.size());
        for (int e = 0; e < int(topology.edges.size()); ++e) {
            const MeshEdge &edge = topology.edges[e];
            QVERIFY(edge.v0 < edge.v1);
            QVERIFY(e == 0 || std::pair(topology.edges[e - 1].v0, topology.edges[e - 1].v1) <
                                  std::pair(edge.v0, edge.v1));
            QCOMPARE(topology.edgeBetween(edge.v1, edge.v0), e);
            QCOMPARE(topology.neighbour(edge.v0, e), edge.v1);
            QCOMPARE(topology.neighbour(edge.v1, e), edge.v0);
            int count = 0;
            for (int f = 0; f < mesh.triangleCount(); ++f)
                count += int(std::count(topology.faceEdges[f].begin(), topology.faceEdges[f].end(), e));
            QCOMPARE(edge.faceCount, count);
            if (count == 2)
                QCOMPARE(topology.across(e, edge.faces[0]), edge.faces[1]);
        }
        for (int f = 0; f < mesh.triangleCount(); ++f)
            for (int k = 0; k < 3; ++k)
                QCOMPARE(topology.faceEdges[f][k],
                         topology.edgeBetween(mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3]));
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            std::vector<int> faces, edges;
            for (int f = 0; f < mesh.triangleCount(); ++f)
                if (std::count(mesh.triangles[f].begin(), mesh.triangles[f].end(), v))
                    faces.push_back(f);
            for (int e = 0; e < int(topology.edges.size()); ++e)
                if (topology.edges[e].v0 == v || topology.edges[e].v1 == v)
                    edges.push_back(e);
            QCOMPARE(topology.vertexFaces[v], faces);
            QCOMPARE(topology.vertexEdges[v], edges);
        }
    }
    QCOMPARE(MeshTopology(zoo::box()).edgeBetween(0, 7), -1);
    QCOMPARE(MeshTopology(zoo::box()).edgeBetween(7, 7), -1);
}

void MeshTopologyTest::closedSurfacesHaveTheirEulerCharacteristic()
{
    for (const auto &[mesh, expected] : {std::pair(zoo::icosphere(3), 2), std::pair(zoo::torus(), 0)}) {
        const ManifoldReport report = manifoldReport(mesh);
        QVERIFY(report.isClosed());
        QCOMPARE(report.components, 1);
        QCOMPARE(mesh.vertexCount() - int(MeshTopology(mesh).edges.size()) + mesh.triangleCount(), expected);
    }
}

void MeshTopologyTest::gridHasOneBorderAroundIt()
{
    const TriangleMesh mesh = zoo::grid(6);
    const MeshTopology topology(mesh);
    const std::vector<char> border = topology.borderVertices();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3 &p = mesh.vertices[v];
        QCOMPARE(bool(border[v]), p.x() == 0.0 || p.x() == 1.0 || p.y() == 0.0 || p.y() == 1.0);
    }
    const ManifoldReport report = manifoldReport(mesh);
    QCOMPARE(report.borderEdges, 24);
    QVERIFY(report.isManifold());
    QVERIFY(!report.isClosed());
}

void MeshTopologyTest::reportSeesEachKindOfDefect()
{
    const ManifoldReport vertex = manifoldReport(zoo::tetrahedraSharingVertex());
    QCOMPARE(vertex.nonManifoldVertices, 1);
    QCOMPARE(vertex.nonManifoldEdges, 0);
    QCOMPARE(vertex.components, 2);
    QVERIFY(!vertex.isManifold());

    const ManifoldReport edge = manifoldReport(zoo::tetrahedraSharingEdge());
    QCOMPARE(edge.nonManifoldEdges, 1);
    QCOMPARE(edge.nonManifoldVertices, 2);
    QCOMPARE(edge.components, 1);

    TriangleMesh turned = zoo::icosphere(1);
    std::swap(turned.triangles[5][0], turned.triangles[5][1]);
    QCOMPARE(manifoldReport(turned).inconsistentEdges, 3);

    QCOMPARE(manifoldReport(zoo::sheetWithFin()).nonManifoldEdges, 1);
    QVERIFY(manifoldReport(zoo::moebiusStrip()).inconsistentEdges > 0);
    QCOMPARE(manifoldReport(zoo::moebiusStrip()).nonManifoldVertices, 0);

    TriangleMesh flat = zoo::grid(1);
    flat.vertices[3] = flat.vertices[0];
    QCOMPARE(manifoldReport(flat).degenerateTriangles, 2);
}

void MeshTopologyTest::componentsAreNumberedByFirstTriangle()
{
    TriangleMesh mesh = zoo::together(zoo::tetrahedron(), zoo::tetrahedron({5, 0, 0}));
    std::swap(mesh.triangles[1], mesh.triangles[5]);
    int count = 0;
    QCOMPARE(triangleComponents(MeshTopology(mesh), &count), (std::vector<int>{0, 1, 0, 0, 1, 0, 1, 1}));
    QCOMPARE(count, 2);
    QVERIFY(triangleComponents(MeshTopology(TriangleMesh()), &count).empty());
    QCOMPARE(count, 0);
}

void MeshTopologyTest::triangleWithARepeatedCornerIsOnlyCounted()
{
    TriangleMesh mesh = zoo::tetrahedron();
    mesh.triangles.push_back({1, 1, 2});
    const ManifoldReport report = manifoldReport(mesh);
    QCOMPARE(report.degenerateTriangles, 1);
    QVERIFY(report.isClosed());
    QCOMPARE(MeshTopology(mesh).faceEdges[4], (std::array<int, 3>{-1, -1, -1}));
}

QTEST_APPLESS_MAIN(MeshTopologyTest)
#include "mesh_topology_test.moc"
