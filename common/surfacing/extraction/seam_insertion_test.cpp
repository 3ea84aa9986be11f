#include "surfacing/extraction/seam_insertion.h"

#include "base/random.h"
#include "support/mesh_zoo.h"

#include <QtTest>
#include <set>

using namespace ductus;

namespace {

SeamedMesh seamed(const TriangleMesh &mesh, const std::vector<int> &labels, double position = 0.5)
{
    const MeshTopology topology(mesh);
    return insertSeams(mesh, topology, labels, std::vector<double>(topology.edges.size(), position));
}

TriangleMesh oneTriangle()
{
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
}

std::vector<int> randomLabels(int count, int labelCount, std::uint64_t seed)
{
    Random random(seed);
    std::vector<int> labels;
    for (int i = 0; i < count; ++i)
        labels.push_back(random.index(labelCount));
    return labels;
}

} // namespace

class SeamInsertionTest : public QObject
{
    Q_OBJECT
private slots:
    void oneLabelChangesNothing();
    void twoLabelsMakeThreeTriangles();
    void threeLabelsMakeSix();
    void keepsAreaAndOrientation();
    void keepsManifolds();
    void everyTriangleHasALabelOfItsCorners();
    void seamEdgesAreWhereLabelsDiffer();
    void cutsWhereItIsTold();
    void cutsAreClampedAwayFromCorners();
};

void SeamInsertionTest::oneLabelChangesNothing()
{
    const TriangleMesh mesh = zoo::icosphere(1);
    const SeamedMesh result = seamed(mesh, std::vector<int>(mesh.vertices.size(), 4));
    QCOMPARE(result.mesh.vertices, mesh.vertices);
    QCOMPARE(result.mesh.triangleCount(), mesh.triangleCount());
    QCOMPARE(result.triangleLabels, std::vector<int>(mesh.triangles.size(), 4));
    QVERIFY(result.seamEdges.empty());
}

void SeamInsertionTest::twoLabelsMakeThreeTriangles()
{
    for (int lone = 0; lone < 3; ++lone) {
        std::vector<int> labels(3, 2);
        labels[lone] = 7;
        const SeamedMesh result = seamed(oneTriangle(), labels);
        QCOMPARE(result.mesh.triangleCount(), 3);
        QCOMPARE(result.mesh.vertexCount(), 5);
        QCOMPARE(std::count(result.triangleLabels.begin(), result.triangleLabels.end(), 7), 1);
        QCOMPARE(result.vertexLabels[3], (std::vector<int>{2, 7}));
        QCOMPARE(result.vertexLabels[4], (std::vector<int>{2, 7}));
        QCOMPARE(result.seamEdges.size(), std::size_t(1));
        QVERIFY(std::abs(surfaceArea(result.mesh) - 0.5) < 1e-14);
    }
}

void SeamInsertionTest::threeLabelsMakeSix()
{
    const SeamedMesh result = seamed(oneTriangle(), {5, 1, 3});
    QCOMPARE(result.mesh.triangleCount(), 6);
    QCOMPARE(result.mesh.vertexCount(), 7);
    for (int label : {1, 3, 5})
        QCOMPARE(std::count(result.triangleLabels.begin(), result.triangleLabels.end(), label), 2);
    QCOMPARE(result.vertexLabels[6], (std::vector<int>{1, 3, 5}));
    QCOMPARE(result.seamEdges.size(), std::size_t(3));
    for (const auto &[a, b] : result.seamEdges)
        QVERIFY(a == 6 || b == 6);
    QVERIFY(std::abs(surfaceArea(result.mesh) - 0.5) < 1e-14);
}

void SeamInsertionTest::keepsAreaAndOrientation()
{
    const TriangleMesh mesh = zoo::grid(15);
    const MeshTopology topology(mesh);
    Random random(3);
    std::vector<double> positions(topology.edges.size());
    for (double &t : positions)
        t = random.uniform(-0.2, 1.2);
    for (int labelCount : {2, 3, 9}) {
        const SeamedMesh result =
            insertSeams(mesh, topology, randomLabels(mesh.vertexCount(), labelCount, 5), positions);
        QVERIFY(std::abs(surfaceArea(result.mesh) - 1.0) < 1e-12);
        for (int t = 0; t < result.mesh.triangleCount(); ++t)
            QVERIFY(result.mesh.areaVector(t).z() > 0.0);
    }
}

void SeamInsertionTest::keepsManifolds()
{
    for (const TriangleMesh &mesh : {zoo::icosphere(3), zoo::torus(), zoo::grid(20, 0.2)})
        for (int labelCount : {2, 3, 12}) {
            const SeamedMesh result = seamed(mesh, randomLabels(mesh.vertexCount(), labelCount, 9));
            const ManifoldReport before = manifoldReport(mesh), after = manifoldReport(result.mesh);
            QVERIFY(after.isManifold());
            QCOMPARE(after.isClosed(), before.isClosed());
            QCOMPARE(after.components, before.components);
            QCOMPARE(after.degenerateTriangles, 0);
            const auto euler = [](const TriangleMesh &m) {
                return m.vertexCount() - int(MeshTopology(m).edges.size()) + m.triangleCount();
            };
            QCOMPARE(euler(result.mesh), euler(mesh));
        }
}

void SeamInsertionTest::everyTriangleHasALabelOfItsCorners()
{
    const TriangleMesh mesh = zoo::icosphere(3);
    const std::vector<int> labels = randomLabels(mesh.vertexCount(), 4, 2);
    const SeamedMesh result = seamed(mesh, labels);
    QCOMPARE(result.triangleLabels.size(), result.mesh.triangles.size());
    QCOMPARE(result.vertexLabels.size(), result.mesh.vertices.size());
    for (std::size_t v = 0; v < result.vertexLabels.size(); ++v) {
        const std::vector<int> &own = result.vertexLabels[v];
        QVERIFY(std::is_sorted(own.begin(), own.end()));
        QVERIFY(std::adjacent_find(own.begin(), own.end()) == own.end());
        if (v < labels.size())
            QCOMPARE(own, std::vector<int>{labels[v]});
        else
            QVERIFY(own.size() == 2 || own.size() == 3);
    }
    std::vector<std::set<int>> around(result.mesh.vertices.size());
    for (std::size_t t = 0; t < result.triangleLabels.size(); ++t)
        for (int v : result.mesh.triangles[t]) {
            const std::vector<int> &own = result.vertexLabels[v];
            QVERIFY(std::count(own.begin(), own.end(), result.triangleLabels[t]) == 1);
            around[v].insert(result.triangleLabels[t]);
        }
    for (std::size_t v = 0; v < around.size(); ++v) // and no label without a triangle
        QCOMPARE(around[v].size(), result.vertexLabels[v].size());
}

void SeamInsertionTest::seamEdgesAreWhereLabelsDiffer()
{
    const TriangleMesh mesh = zoo::torus();
    const SeamedMesh result = seamed(mesh, randomLabels(mesh.vertexCount(), 5, 4));
    std::set<std::pair<int, int>> expected;
    for (const MeshEdge &e : MeshTopology(result.mesh).edges)
        if (result.triangleLabels[e.faces[0]] != result.triangleLabels[e.faces[1]])
            expected.insert({e.v0, e.v1});
    QVERIFY(!expected.empty());
    std::set<std::pair<int, int>> found;
    for (const auto &[a, b] : result.seamEdges) {
        found.insert({std::min(a, b), std::max(a, b)});
        QVERIFY(a >= mesh.vertexCount() && b >= mesh.vertexCount()); // never along an old edge
    }
    QCOMPARE(result.seamEdges.size(), found.size());
    QVERIFY(found == expected);
}

void SeamInsertionTest::cutsWhereItIsTold()
{
    const TriangleMesh mesh = zoo::grid(8);
    const MeshTopology topology(mesh);
    std::vector<int> labels;
    for (const Vec3 &p : mesh.vertices)
        labels.push_back(p.x() > 0.55);
    std::vector<double> positions(topology.edges.size(), 0.5);
    for (std::size_t e = 0; e < positions.size(); ++e) {
        const double a = mesh.vertices[topology.edges[e].v0].x(), b = mesh.vertices[topology.edges[e].v1].x();
        if (a != b)
            positions[e] = (0.55 - a) / (b - a);
    }
    const SeamedMesh result = insertSeams(mesh, topology, labels, positions);
    QVERIFY(result.mesh.vertexCount() > mesh.vertexCount());
    for (int v = mesh.vertexCount(); v < result.mesh.vertexCount(); ++v)
        QVERIFY(std::abs(result.mesh.vertices[v].x() - 0.55) < 1e-12);
    QCOMPARE(result.seamEdges.size(), std::size_t(16));
}

void SeamInsertionTest::cutsAreClampedAwayFromCorners()
{
    for (double position : {0.0, 1.0, -3.0, 4.0}) {
        const TriangleMesh mesh = zoo::grid(4);
        const SeamedMesh result = seamed(mesh, randomLabels(mesh.vertexCount(), 3, 1), position);
        QCOMPARE(manifoldReport(result.mesh).degenerateTriangles, 0);
        for (int v = mesh.vertexCount(); v < result.mesh.vertexCount(); ++v)
            for (const Vec3 &corner : mesh.vertices)
                QVERIFY((result.mesh.vertices[v] - corner).norm() > 0.02);
    }
}

QTEST_APPLESS_MAIN(SeamInsertionTest)
#include "seam_insertion_test.moc"
