#include "imaging/picture/corner_normals.h"

#include <QtTest>
#include <cmath>
#include <numbers>

using namespace ductus;
using namespace ductus::picture;

namespace {

// Two rectangles that meet at the y axis, the second bent back by \a degrees.
TriangleMesh fold(double degrees)
{
    const double angle = degrees * std::numbers::pi / 180.0;
    const double x = std::cos(angle), z = -std::sin(angle);
    TriangleMesh mesh;
    mesh.vertices = {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {x, 0, z}, {x, 1, z}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
    return mesh;
}

bool never(int, int)
{
    return false;
}

} // namespace

class CornerNormalsTest : public QObject
{
    Q_OBJECT
private slots:
    void gentleEdgesAreSmoothSharpOnesBreak();
    void anglesWeighNotTriangleCounts();
    void creaseEdgesAreSharpOpenOrColourBorders();
    void tinyAndFlatTriangles();
};

void CornerNormalsTest::gentleEdgesAreSmoothSharpOnesBreak()
{
    const CornerNormals gentle = cornerNormals(fold(30.0), 40.0);
    const Vec3 middle(std::sin(15.0 * std::numbers::pi / 180.0), 0.0,
                      std::cos(15.0 * std::numbers::pi / 180.0));
    QVERIFY((gentle.corners[0][1] - middle).norm() < 1e-9);
    QVERIFY((gentle.corners[2][0] - middle).norm() < 1e-9);
    QVERIFY((gentle.corners[0][0] - Vec3::UnitZ()).norm() < 1e-9); // away from the edge
    const CornerNormals sharp = cornerNormals(fold(50.0), 40.0);
    QVERIFY((sharp.corners[0][1] - Vec3::UnitZ()).norm() < 1e-9);
    QVERIFY((sharp.corners[2][0] - sharp.faces[2]).norm() < 1e-9);
    const CornerNormals flat = cornerNormals(fold(30.0), 0.0);
    QVERIFY(flat.corners[0][1] == flat.faces[0]);
}

void CornerNormalsTest::anglesWeighNotTriangleCounts()
{
    // At vertex 1 the first side has one right angle, at vertex 2 it has two of 45 degrees; both weigh the
    // same.
    const CornerNormals normals = cornerNormals(fold(30.0), 40.0);
    QVERIFY((normals.corners[0][1] - normals.corners[0][2]).norm() < 1e-9);
}

void CornerNormalsTest::creaseEdgesAreSharpOpenOrColourBorders()
{
    using Pairs = std::vector<std::pair<int, int>>;
    const Pairs border{{0, 1}, {0, 3}, {1, 4}, {2, 3}, {2, 5}, {4, 5}};
    QCOMPARE(creaseEdges(fold(30.0), 40.0, never), border);
    Pairs withRidge = border;
    withRidge.insert(withRidge.begin() + 2, {1, 2});
    QCOMPARE(creaseEdges(fold(50.0), 40.0, never), withRidge);
    // Colours: the first rectangle against the second.
    QCOMPARE(creaseEdges(fold(30.0), 40.0, [](int t, int u) { return t / 2 != u / 2; }), withRidge);
}

void CornerNormalsTest::tinyAndFlatTriangles()
{
    TriangleMesh mesh = fold(30.0);
    for (Vec3 &v : mesh.vertices)
        v *= 1e-30;
    QVERIFY((cornerNormals(mesh, 40.0).faces[0] - Vec3::UnitZ()).norm() < 1e-9);
    TriangleMesh line;
    line.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    line.triangles = {{0, 1, 2}};
    QVERIFY(cornerNormals(line, 40.0).faces[0].isZero());
}

QTEST_APPLESS_MAIN(CornerNormalsTest)
#include "corner_normals_test.moc"
