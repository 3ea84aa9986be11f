#include "geometry/mesh_topology.h"
#include "geometry/remesh.h"

#include "base/random.h"
#include "support/mesh_zoo.h"

#include <QtTest>
#include <limits>

using namespace ductus;

namespace {

struct Repaired
{
    TriangleMesh mesh;
    RepairReport told;
    ManifoldReport is;
};

/// A refused repair is reported as no manifold.
Repaired repair(const TriangleMesh &mesh)
{
    Repaired r;
    if (Result<TriangleMesh> result = repaired(mesh, &r.told); result.ok())
        r.mesh = std::move(*result);
    r.is = manifoldReport(r.mesh);
    if (r.mesh.isEmpty())
        r.is.nonManifoldEdges = -1;
    return r;
}

} // namespace

class RepairTest : public QObject
{
    Q_OBJECT
private slots:
    void soundMeshesStayAsTheyAre();
    void trianglesOfAnStlFileAreJoined();
    void mixedOrientationBecomesOutwards();
    void cavitiesAndOpenSheetsAreOriented();
    void touchingSolidsAreTakenApart();
    void duplicatesAndDegenerateTrianglesGo();
    void capsLeaveNoCrack();
    void sheetKeepsItsSmoothestContinuation();
    void crossedSheetsStayTwoSheets();
    void moebiusStripIsCutOpen();
    void doubleJointsGetAMiddleVertex();
    void selfIntersectionIsTold();
    void hostileInputIsRefused();
    void mostlyRubbishIsRefused();
    void randomSoupsBecomeManifolds();
    void repairIsDeterministicAndItsResultSound();
};

void RepairTest::soundMeshesStayAsTheyAre()
{
    for (const TriangleMesh &mesh : {zoo::icosphere(2), zoo::torus(), zoo::grid(4, 0.3), zoo::box()}) {
        const Repaired r = repair(mesh);
        QVERIFY(r.mesh.vertices == mesh.vertices);
        QVERIFY(r.mesh.triangles == mesh.triangles);
        QCOMPARE(r.told.mergedVertices + r.told.removedTriangles + r.told.splitVertices +
                     r.told.reorientedTriangles,
                 0);
        QVERIFY(!r.told.selfIntersecting);
    }
}

void RepairTest::trianglesOfAnStlFileAreJoined()
{
    const TriangleMesh sphere = zoo::icosphere(3);
    const Repaired r = repair(zoo::exploded(sphere));
    QVERIFY(r.is.isClosed());
    QCOMPARE(r.mesh.vertexCount(), sphere.vertexCount());
    QCOMPARE(r.told.mergedVertices, 3 * sphere.triangleCount() - sphere.vertexCount());

    TriangleMesh zeros = zoo::exploded(zoo::box()); // -0 and 0 are the same place
    for (std::size_t v = 0; v < zeros.vertices.size(); v += 2)
        for (int k = 0; k < 3; ++k)
            if (zeros.vertices[v][k] == 0.0)
                zeros.vertices[v][k] = -0.0;
    QVERIFY(repair(zeros).is.isClosed());
}

void RepairTest::mixedOrientationBecomesOutwards()
{
    for (const TriangleMesh &sound : {zoo::icosphere(2), zoo::torus(), zoo::tetrahedron({100, 100, 100})}) {
        TriangleMesh mesh = sound;
        Random random(31);
        int turned = 0;
        for (Triangle &t : mesh.triangles) {
            if (random.uniform() < 0.4) {
                std::swap(t[0], t[1]);
                ++turned;
            }
        }
        const Repaired r = repair(mesh);
        QVERIFY(r.is.isClosed());
        QCOMPARE(r.told.reorientedTriangles, turned);
        QVERIFY(std::abs(signedVolume(r.mesh) - signedVolume(sound)) < 1e-9);
    }
    const Repaired r = repair(zoo::turnedOver(zoo::box()));
    QVERIFY(std::abs(signedVolume(r.mesh) - 1.0) < 1e-12);
}

void RepairTest::cavitiesAndOpenSheetsAreOriented()
{
    TriangleMesh sheet = zoo::grid(6);
    std::swap(sheet.triangles[0][1], sheet.triangles[0][2]); // the first triangle is in the minority
    std::swap(sheet.triangles[9][1], sheet.triangles[9][2]);
    const Repaired r = repair(sheet);
    QVERIFY(r.is.isManifold());
    QCOMPARE(r.told.reorientedTriangles, 2);
    for (int t = 0; t < r.mesh.triangleCount(); ++t)
        QVERIFY(r.mesh.faceNormal(t).z() > 0.999);

    const TriangleMesh two = zoo::together(zoo::turnedOver(zoo::box()), zoo::box({3, 0, 0}, {4, 1, 1}));
    QVERIFY(std::abs(signedVolume(repair(two).mesh) - 2.0) < 1e-12);
}

void RepairTest::touchingSolidsAreTakenApart()
{
    const Repaired vertex = repair(zoo::tetrahedraSharingVertex());
    QVERIFY(vertex.is.isClosed());
    QCOMPARE(vertex.told.splitVertices, 1);
    QCOMPARE(vertex.mesh.vertexCount(), 8);

    const Repaired edge = repair(zoo::tetrahedraSharingEdge());
    QVERIFY(edge.is.isClosed());
    QCOMPARE(edge.told.splitVertices, 2);
    QCOMPARE(edge.is.components, 2);
    QVERIFY(!edge.told.selfIntersecting);
    QVERIFY(std::abs(signedVolume(edge.mesh) - signedVolume(zoo::tetrahedraSharingEdge())) < 1e-12);

    // Two boxes like black squares of a chess board, vertices merged along the common edge.
    const Repaired boxes = repair(zoo::together(zoo::box(), zoo::box({1, 1, 0}, {2, 2, 1})));
    QCOMPARE(boxes.told.mergedVertices, 2);
    QVERIFY(boxes.is.isClosed());
    QCOMPARE(boxes.is.components, 2);
}

void RepairTest::duplicatesAndDegenerateTrianglesGo()
{
    TriangleMesh mesh = zoo::icosphere(1);
    mesh.triangles.push_back(mesh.triangles[3]);
    const Triangle t = mesh.triangles[7];
    mesh.triangles.push_back({t[2], t[1], t[0]}); // turned over, still the same place
    mesh.triangles.push_back({4, 4, 5});
    mesh.vertices.push_back(Vec3(mesh.vertices[6]));
    mesh.triangles.push_back({6, mesh.vertexCount() - 1, 0}); // repeated corner once merged
    const Repaired r = repair(mesh);
    QVERIFY(r.is.isClosed());
    QCOMPARE(r.told.removedTriangles, 4);
    QVERIFY(r.mesh.triangles == zoo::icosphere(1).triangles);
}

void RepairTest::capsLeaveNoCrack()
{
    // A box whose top is cut from edge middle to corner, the T-junction closed by a triangle without area.
    TriangleMesh mesh = zoo::box();
    mesh.vertices.push_back({0.5, 0, 1}); // on edge 4-5
    std::erase(mesh.triangles, Triangle{4, 5, 7});
    mesh.triangles.insert(mesh.triangles.end(), {{4, 8, 7}, {8, 5, 7}, {4, 5, 8}});
    QVERIFY(manifoldReport(mesh).isClosed());
    QCOMPARE(manifoldReport(mesh).degenerateTriangles, 1);
    const Repaired r = repair(mesh);
    QVERIFY(r.is.isClosed());
    QCOMPARE(r.is.degenerateTriangles, 0);
    QCOMPARE(r.told.removedTriangles, 1);
    QVERIFY(std::abs(signedVolume(r.mesh) - 1.0) < 1e-12);

    // A needle: one edge of a sphere opened by a gap far below any meaning.
    TriangleMesh needle = zoo::exploded(zoo::icosphere(0));
    needle = repair(needle).mesh;
    const Triangle first = needle.triangles[0];
    needle.vertices.push_back(Vec3(needle.vertices[first[0]] * (1.0 + 1e-15)));
    const int copy = needle.vertexCount() - 1;
    needle.triangles[0] = {copy, first[1], first[2]};
    needle.triangles.push_back({first[0], first[1], copy});
    needle.triangles.push_back({first[0], copy, first[2]});
    QVERIFY(manifoldReport(needle).isClosed());
    const Repaired n = repair(needle);
    QVERIFY(n.is.isClosed());
    QCOMPARE(n.mesh.triangleCount(), 20);
}

void RepairTest::sheetKeepsItsSmoothestContinuation()
{
    const Repaired r = repair(zoo::sheetWithFin());
    QVERIFY(r.is.isManifold());
    QCOMPARE(r.is.components, 2);
    QCOMPARE(r.told.removedTriangles, 0);
    QCOMPARE(r.is.borderEdges, 8 + 3); // the sheet's and the fin's own
}

void RepairTest::crossedSheetsStayTwoSheets()
{
    const Repaired r = repair(zoo::crossedSheets());
    QVERIFY(r.is.isManifold());
    QCOMPARE(r.is.components, 2);
    QCOMPARE(r.is.borderEdges, 12);
    for (const MeshEdge &edge : MeshTopology(r.mesh).edges)
        if (edge.faceCount == 2)
            QVERIFY(std::abs(r.mesh.faceNormal(edge.faces[0]).dot(r.mesh.faceNormal(edge.faces[1]))) > 0.999);
}

void RepairTest::moebiusStripIsCutOpen()
{
    for (int width : {1, 2, 5}) {
        const TriangleMesh strip = zoo::moebiusStrip(24, width);
        const Repaired r = repair(strip);
        QVERIFY(r.is.isManifold());
        QCOMPARE(r.is.components, 1);
        QCOMPARE(r.mesh.triangleCount(), strip.triangleCount());
        const MeshTopology topology(r.mesh);
        QCOMPARE(r.mesh.vertexCount() - int(topology.edges.size()) + r.mesh.triangleCount(), 1); // a disc
    }
}

void RepairTest::doubleJointsGetAMiddleVertex()
{
    // Two closed sheets (two-triangle pillows would be duplicates, so with a tip each) joined in a ring along
    // the edge 0-1 such that both ends of the edge hang together around it.
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {0, 1, 0.5}, {-1, 0, 0.5}, {0, -1, 0.5}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}, {0, 2, 3}, {0, 3, 4},
                      {0, 4, 5}, {0, 5, 2}, {1, 2, 3}, {1, 3, 4}, {1, 4, 5}, {1, 5, 2}};
    const Repaired r = repair(mesh);
    QVERIFY(!r.mesh.isEmpty());
    QVERIFY(r.is.isManifold());
    QVERIFY(std::abs(surfaceArea(r.mesh) - surfaceArea(mesh)) < 1e-12);
}

void RepairTest::selfIntersectionIsTold()
{
    const TriangleMesh apart = zoo::together(zoo::box(), zoo::box({2, 0, 0}, {3, 1, 1}));
    QVERIFY(!repair(apart).told.selfIntersecting);
    const TriangleMesh crossing = zoo::together(zoo::box(), zoo::box({0.5, 0.3, 0.2}, {2, 0.6, 0.7}));
    QVERIFY(repair(crossing).told.selfIntersecting);

    TriangleMesh folded; // two triangles on the same side of a common edge, in one plane
    folded.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.6, 0.5, 0}};
    folded.triangles = {{0, 1, 2}, {1, 0, 3}};
    QVERIFY(repair(folded).told.selfIntersecting);
    folded.vertices[3].y() = -0.5;
    QVERIFY(!repair(folded).told.selfIntersecting);

    TriangleMesh spike; // two triangles with one common corner, one pierces the other
    spike.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, 1}, {0.5, 0.5, -1}};
    spike.triangles = {{0, 1, 2}, {0, 3, 4}};
    QVERIFY(repair(spike).told.selfIntersecting);
}

void RepairTest::hostileInputIsRefused()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (double bad : {nan, infinity, -infinity, 1e300}) {
        TriangleMesh mesh = zoo::box();
        mesh.vertices[3].y() = bad;
        const Result<TriangleMesh> result = repaired(mesh);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::Malformed);
        QVERIFY(result.error().problem.find("vertex 3") != std::string::npos);
    }
    for (int bad : {-1, 8, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
        TriangleMesh mesh = zoo::box();
        mesh.triangles[5][2] = bad;
        QCOMPARE(repaired(mesh).error().code, ErrorCode::Malformed);
    }
    QCOMPARE(repaired({}).error().code, ErrorCode::TooLittleData);
    TriangleMesh line;
    line.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    line.triangles = {{0, 1, 2}, {1, 2, 3}, {0, 3, 1}};
    QCOMPARE(repaired(line).error().code, ErrorCode::TooLittleData);
}

void RepairTest::mostlyRubbishIsRefused()
{
    TriangleMesh mesh = zoo::tetrahedron();
    for (int i = 0; i < 3; ++i)
        mesh.triangles.insert(mesh.triangles.end(), mesh.triangles.begin(), mesh.triangles.begin() + 4);
    QCOMPARE(repaired(mesh).error().code, ErrorCode::NoSolution);
}

void RepairTest::randomSoupsBecomeManifolds()
{
    Random random(32);
    int sick = 0;
    for (int run = 0; run < 300; ++run) {
        TriangleMesh mesh;
        const int vertices = 4 + random.index(9);
        for (int v = 0; v < vertices; ++v) {
            // Few coordinates, so that equal and collinear vertices are common.
            const int x = random.index(4), y = random.index(4);
            mesh.vertices.push_back(Vec3(x, y, random.index(3)));
        }
        for (int t = 0, n = 1 + random.index(40); t < n; ++t) {
            const int a = random.index(vertices), b = random.index(vertices);
            mesh.triangles.push_back({a, b, random.index(vertices)});
        }
        sick += manifoldReport(mesh).isManifold() ? 0 : 1;
        const Result<TriangleMesh> result = repaired(mesh);
        if (!result) {
            QVERIFY(result.error().code == ErrorCode::NoSolution ||
                    result.error().code == ErrorCode::TooLittleData);
            continue;
        }
        const ManifoldReport report = manifoldReport(*result);
        QVERIFY2(report.isManifold() && report.degenerateTriangles == 0, qPrintable(QString::number(run)));
        QVERIFY(surfaceArea(*result) >= 0.5 * surfaceArea(mesh) - 1e-9);
    }
    QVERIFY(sick > 200);
}

void RepairTest::repairIsDeterministicAndItsResultSound()
{
    TriangleMesh mesh = zoo::together(zoo::moebiusStrip(), zoo::crossedSheets());
    mesh = zoo::together(mesh, zoo::exploded(zoo::tetrahedraSharingEdge()));
    const Repaired first = repair(mesh);
    const Repaired second = repair(mesh);
    QVERIFY(!first.mesh.isEmpty());
    QVERIFY(first.mesh.vertices == second.mesh.vertices);
    QVERIFY(first.mesh.triangles == second.mesh.triangles);
}

QTEST_APPLESS_MAIN(RepairTest)
#include "repair_test.moc"
