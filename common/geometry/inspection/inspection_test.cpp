// Walls, gaps and crossings of solids whose measures are known.
#include "geometry/inspection/print_check.h"
#include "geometry/inspection/ray_tree.h"
#include "support/mesh_zoo.h"

#include <QtTest>
#include <atomic>

using namespace ductus;

namespace {

TriangleMesh together(TriangleMesh a, const TriangleMesh &b)
{
    const int offset = a.vertexCount();
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Triangle &t : b.triangles)
        a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

TriangleMesh insideOut(TriangleMesh mesh)
{
    for (Triangle &t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
}

PrintCheck checkOf(const TriangleMesh &mesh)
{
    const Result<PrintCheck> check = checkForPrint(mesh, JobControl());
    return check ? *check : PrintCheck();
}

bool isNear(double value, double expected, double tolerance = 1e-9)
{
    return std::abs(value - expected) <= tolerance;
}

} // namespace

class InspectionTest : public QObject
{
    Q_OBJECT
private slots:
    void aBoxIsAsThickAsItsShortestSide();
    void aPlateIsThin();
    void aHollowBallHasAWall();
    void aSolidBallIsAsThickAsItsDiameter();
    void aSlotIsAGap();
    void anOpenBoxHasNoWalls();
    void aWedgeIsNoWallAtARightAngle();
    void crossingShellsAreTold();
    void aShellThatRunsThroughItselfIsTold();
    void soundMeshesDoNotCross();
    void theSearchStopsWhenEnoughIsFound();
    void raysBeginBehindWhereTheyAreTold();
    void cancelledMeasuringSaysSo();
};

void InspectionTest::aBoxIsAsThickAsItsShortestSide()
{
    const PrintCheck check = checkOf(zoo::box(Vec3::Zero(), Vec3(3, 2, 5)));
    QVERIFY(check.isWatertight);
    QCOMPARE(check.shells, 1);
    QVERIFY(isNear(check.volume, 30.0) && isNear(check.area, 62.0));
    QVERIFY(check.thinnestWall && isNear(check.thinnestWall->length, 2.0));
    QVERIFY(isNear(std::abs(check.thinnestWall->place.y() - check.thinnestWall->opposite.y()), 2.0));
    QVERIFY(!check.narrowestGap && check.crossings.empty() && check.overlaps.empty());
    QVERIFY(isNear(check.thickness.shareThinnerThan(2.5), 30.0 / 62.0, 1e-6));
    QVERIFY(isNear(check.thickness.shareThinnerThan(1.9), 0.0));
    // Every place was measured: 5 of the sides are 3, 2 and 5 apart, no ray is lost at an edge.
    QVERIFY(isNear(check.thickness.shareThinnerThan(5.5), 1.0, 1e-6));
}

void InspectionTest::aPlateIsThin()
{
    const PrintCheck check = checkOf(zoo::box(Vec3::Zero(), Vec3(100, 0.4, 80)));
    QVERIFY(check.thinnestWall && isNear(check.thinnestWall->length, 0.4, 1e-6));
    QVERIFY(check.thickness.shareThinnerThan(0.8) > 0.98);
}

void InspectionTest::aHollowBallHasAWall()
{
    TriangleMesh inner = zoo::icosphere(4);
    for (Vec3 &v : inner.vertices)
        v *= 0.9;
    const PrintCheck check = checkOf(together(zoo::icosphere(4), insideOut(inner)));
    QVERIFY(check.isWatertight);
    QCOMPARE(check.shells, 2);
    QVERIFY2(check.thinnestWall && isNear(check.thinnestWall->length, 0.1, 0.003),
             qPrintable(QString::number(check.thinnestWall->length)));
    // Across the hollow.
    QVERIFY(check.narrowestGap && isNear(check.narrowestGap->length, 1.8, 0.02));
}

void InspectionTest::aSolidBallIsAsThickAsItsDiameter()
{
    const PrintCheck check = checkOf(zoo::icosphere(4));
    QVERIFY(check.thinnestWall && isNear(check.thinnestWall->length, 2.0, 0.02));
    QVERIFY(!check.narrowestGap);
}

void InspectionTest::aSlotIsAGap()
{
    const PrintCheck check =
        checkOf(together(zoo::box(Vec3::Zero(), Vec3(1, 1, 1)), zoo::box(Vec3(1.05, 0, 0), Vec3(2, 1, 1))));
    QVERIFY(check.narrowestGap && isNear(check.narrowestGap->length, 0.05));
    QVERIFY(check.thinnestWall && isNear(check.thinnestWall->length, 0.95));
}

void InspectionTest::anOpenBoxHasNoWalls()
{
    TriangleMesh open = zoo::box();
    open.triangles.resize(10);
    const PrintCheck check = checkOf(open);
    QVERIFY(!check.isWatertight && check.borderEdges > 0 && check.border);
    QVERIFY(!check.thinnestWall && check.volume == 0.0);
}

void InspectionTest::aWedgeIsNoWallAtARightAngle()
{
    // Both short sides meet in a right angle: rays near it see the long one at 45 degrees and count nothing.
    TriangleMesh wedge;
    wedge.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 4}, {1, 0, 4}, {0, 1, 4}};
    wedge.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                       {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    const PrintCheck check = checkOf(wedge);
    QVERIFY(check.isWatertight && isNear(check.volume, 2.0));
    QVERIFY(check.thinnestWall && isNear(check.thinnestWall->length, 4.0));
}

void InspectionTest::crossingShellsAreTold()
{
    const PrintCheck check =
        checkOf(together(zoo::box(), zoo::box(Vec3(0.5, 0.5, 0.5), Vec3(1.5, 1.6, 1.7))));
    QVERIFY(check.isWatertight && check.crossings.empty() && !check.crossing);
    QVERIFY(!check.overlaps.empty() && check.overlap);
}

void InspectionTest::aShellThatRunsThroughItselfIsTold()
{
    // A closed box one corner of which is pulled through the opposite side.
    TriangleMesh mesh = zoo::box();
    mesh.vertices[0] = Vec3(0.2, 0.2, 1.5);
    const PrintCheck check = checkOf(mesh);
    QVERIFY(!check.crossings.empty() && check.crossing && check.overlaps.empty());
}

void InspectionTest::soundMeshesDoNotCross()
{
    QVERIFY(selfIntersections(zoo::icosphere(4)).empty());
    QVERIFY(selfIntersections(zoo::box()).empty());
    QVERIFY(selfIntersections(TriangleMesh()).empty());
}

void InspectionTest::theSearchStopsWhenEnoughIsFound()
{
    TriangleMesh shifted = zoo::icosphere(3);
    for (Vec3 &v : shifted.vertices)
        v.x() += 0.7;
    const TriangleMesh both = together(zoo::icosphere(3), shifted);
    const std::vector<TrianglePair> all = selfIntersections(both), five = selfIntersections(both, 5);
    QVERIFY(all.size() > 20);
    QCOMPARE(five.size(), std::size_t(5));
    QVERIFY(std::is_sorted(all.begin(), all.end()));
    QVERIFY(selfIntersections(both) == all);
}

void InspectionTest::raysBeginBehindWhereTheyAreTold()
{
    const RayTree tree(zoo::box());
    QVERIFY(isNear(tree.firstHit({0.4, 0.3, -1}, {0, 0, 1})->distance, 1.0));
    QVERIFY(isNear(tree.firstHit({0.4, 0.3, -1}, {0, 0, 1}, 1.5)->distance, 2.0));
    QVERIFY(!tree.firstHit({0.4, 0.3, -1}, {0, 0, 1}, 2.5));
}

void InspectionTest::cancelledMeasuringSaysSo()
{
    const std::atomic<bool> cancelled = true;
    const Result<PrintCheck> check = checkForPrint(zoo::box(), JobControl(&cancelled, {}));
    QVERIFY(!check && check.error().isCancelled());
}

QTEST_APPLESS_MAIN(InspectionTest)
#include "inspection_test.moc"
