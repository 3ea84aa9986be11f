#include "surfacing/pipeline/finish_surface.h"

#include "support/mesh_zoo.h"

#include <QtTest>

using namespace ductus;

namespace {

Stroke lineAt(double y)
{
    Stroke stroke;
    for (int i = 0; i <= 40; ++i)
        stroke.points.push_back({i / 40.0, y, 0.0});
    return stroke;
}

} // namespace

class FinishSurfaceTest : public QObject
{
    Q_OBJECT
private slots:
    void borderGoesToTheNearestPlaceOnABorderStroke();
    void borderWithoutStrokesIsFree();
    void borderInTheMirrorPlaneIsFree();
    void closedMeshHasNoTargets();
};

void FinishSurfaceTest::borderGoesToTheNearestPlaceOnABorderStroke()
{
    const TriangleMesh mesh = zoo::grid(10);
    StrokeSet strokes;
    strokes.strokes = {Stroke{}};
    strokes.strokes[0].points = {{-0.2, 1.03, 0.0},
                                 {1.2, 1.03, 0.0}}; // the ends are far: the places are between
    const std::vector<BorderAttraction> targets = borderTargets(mesh, strokes, {});
    int atTheTop = 0;
    for (const BorderAttraction &t : targets) {
        const Vec3 p = mesh.vertices[t.vertex];
        QVERIFY((t.target - Vec3(p.x(), 1.03, 0.0)).norm() < 1e-12);
        QVERIFY(p.x() == 0.0 || p.x() == 1.0 || p.y() == 1.0);
        atTheTop += p.y() == 1.0;
    }
    QCOMPARE(atTheTop, 11);
}

void FinishSurfaceTest::borderWithoutStrokesIsFree()
{
    const TriangleMesh mesh = zoo::grid(10);
    StrokeSet strokes;
    strokes.strokes = {lineAt(7.0)};
    QVERIFY(borderTargets(mesh, strokes, {}).empty());
    QVERIFY(borderTargets(mesh, {}, {}).empty());
}

void FinishSurfaceTest::borderInTheMirrorPlaneIsFree()
{
    const TriangleMesh mesh = zoo::grid(10);
    std::vector<char> inPlane;
    for (const Vec3 &p : mesh.vertices)
        inPlane.push_back(p.x() == 0.0);
    StrokeSet strokes;
    strokes.strokes = {Stroke{}};
    strokes.strokes[0].points = {{-0.02, -0.2, 0.0}, {-0.02, 1.2, 0.0}}; // along the plane
    QVERIFY(borderTargets(mesh, strokes, {}).size() >= 11);
    const std::vector<BorderAttraction> targets = borderTargets(mesh, strokes, inPlane);
    QVERIFY(!targets.empty()); // the sides that start in the plane
    for (const BorderAttraction &t : targets)
        QVERIFY(!inPlane[t.vertex]);
}

void FinishSurfaceTest::closedMeshHasNoTargets()
{
    StrokeSet strokes;
    strokes.strokes = {lineAt(0.0)};
    QVERIFY(borderTargets(zoo::icosphere(2), strokes, {}).empty());
}

QTEST_APPLESS_MAIN(FinishSurfaceTest)
#include "finish_surface_test.moc"
