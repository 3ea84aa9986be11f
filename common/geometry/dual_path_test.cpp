#include "geometry/dual_path.h"

#include "base/random.h"
#include "support/mesh_zoo.h"

#include <QtTest>

using namespace ductus;

namespace {

/// Distances in the dual graph by relaxing every arc until nothing changes.
std::vector<double> bruteForceDistances(const TriangleMesh &mesh, const MeshTopology &topology, int from)
{
    std::vector<double> distance(mesh.triangles.size(), 1e300);
    distance[from] = 0.0;
    for (bool changed = true; changed;) {
        changed = false;
        for (const MeshEdge &edge : topology.edges) {
            if (edge.faceCount != 2)
                continue;
            const auto [f, g] = edge.faces;
            const double length = (mesh.centroid(f) - mesh.centroid(g)).norm();
            for (const auto &[a, b] : {std::pair(f, g), std::pair(g, f)}) {
                if (distance[a] + length < distance[b]) {
                    distance[b] = distance[a] + length;
                    changed = true;
                }
            }
        }
    }
    return distance;
}

} // namespace

class DualPathTest : public QObject
{
    Q_OBJECT
private slots:
    void pathsAreAsShortAsBruteForceSays();
    void limitCutsLongPathsOff();
    void otherComponentsAreNotFound();
    void doesNotCrossNonManifoldEdges();
};

void DualPathTest::pathsAreAsShortAsBruteForceSays()
{
    Random random(21);
    for (const TriangleMesh &mesh : {zoo::icosphere(2), zoo::grid(9, 0.5), zoo::torus(1.0, 0.35, 20, 8)}) {
        const MeshTopology topology(mesh);
        DualPaths paths(mesh, topology);
        for (int source = 0; source < 6; ++source) {
            const int from = random.index(mesh.triangleCount());
            const std::vector<double> expected = bruteForceDistances(mesh, topology, from);
            for (int i = 0; i < 60; ++i) {
                const int to = random.index(mesh.triangleCount());
                bool found = false;
                const std::vector<int> crossed = paths.crossedEdges(from, to, 1e9, &found);
                QVERIFY(found);
                double length = 0.0;
                int t = from;
                for (int e : crossed) {
                    const auto &sides = topology.faceEdges[t];
                    QVERIFY(std::find(sides.begin(), sides.end(), e) != sides.end());
                    const int next = topology.across(e, t);
                    length += (mesh.centroid(t) - mesh.centroid(next)).norm();
                    t = next;
                }
                QCOMPARE(t, to);
                QVERIFY(std::abs(length - expected[to]) < 1e-12);
                QCOMPARE(crossed.empty(), from == to);
                QCOMPARE(paths.crossedEdges(from, to, 1e9), crossed);
            }
        }
    }
}

void DualPathTest::limitCutsLongPathsOff()
{
    const TriangleMesh mesh = zoo::grid(8);
    const MeshTopology topology(mesh);
    DualPaths paths(mesh, topology);
    const std::vector<double> distance = bruteForceDistances(mesh, topology, 0);
    for (int t = 1; t < mesh.triangleCount(); ++t) {
        bool found = false;
        QVERIFY(!paths.crossedEdges(0, t, distance[t] * 1.001, &found).empty());
        QVERIFY(found);
        QVERIFY(paths.crossedEdges(0, t, distance[t] * 0.999, &found).empty());
        QVERIFY(!found);
    }
    bool found = false;
    QVERIFY(paths.crossedEdges(5, 5, 0.0, &found).empty());
    QVERIFY(found);
}

void DualPathTest::otherComponentsAreNotFound()
{
    const TriangleMesh mesh = zoo::together(zoo::tetrahedron(), zoo::tetrahedron({3, 0, 0}));
    const MeshTopology topology(mesh);
    DualPaths paths(mesh, topology);
    bool found = true;
    QVERIFY(paths.crossedEdges(0, 5, 1e9, &found).empty());
    QVERIFY(!found);
    QVERIFY(!paths.crossedEdges(4, 5, 1e9, &found).empty());
    QVERIFY(found);
}

void DualPathTest::doesNotCrossNonManifoldEdges()
{
    const TriangleMesh mesh = zoo::sheetWithFin();
    const MeshTopology topology(mesh);
    DualPaths paths(mesh, topology);
    bool found = true;
    QVERIFY(paths.crossedEdges(0, mesh.triangleCount() - 1, 1e9, &found).empty());
    QVERIFY(!found);
}

QTEST_APPLESS_MAIN(DualPathTest)
#include "dual_path_test.moc"
