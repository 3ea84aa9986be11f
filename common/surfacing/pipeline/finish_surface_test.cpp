#include "surfacing/pipeline/finish_surface.h"

#include "support/mesh_zoo.h"

#include <QtTest>

using namespace ductus;

namespace {

Stroke lineAt(double y, StrokeRole role)
{
    Stroke stroke;
    stroke.role = role;
    for (int i = 0; i <= 40; ++i)
        stroke.points.push_back({i / 40.0, y, 0.0});
    return stroke;
}

} // namespace

class FinishSurfaceTest : public QObject
{
    Q_OBJECT
private slots:
    void borderGoesToTheNearestStrokePoint();
    void borderWithoutStrokesStays();
    void otherRolesDrawNothing();
    void borderInTheMirrorPlaneIsFree();
    void closedMeshHasNoTargets();
};

void FinishSurfaceTest::borderGoesToTheNearestStrokePoint()
{
    const TriangleMesh mesh = zoo::grid(10);
    StrokeSet strokes;
    strokes.strokes = {lineAt(1.03, StrokeRole::Boundary), lineAt(0.5, StrokeRole::Surface)};
    const std::vector<BorderAttraction> targets = borderTargets(mesh, strokes, {});
    QCOMPARE(targets.size(), std::size_t(40));
    const std::vector<char> border = MeshTopology(mesh).borderVertices();
    for (const BorderAttraction &t : targets) {
        QVERIFY(border[t.vertex]);
        const Vec3 p = mesh.vertices[t.vertex];
        double nearest = 1e300;
        for (const Vec3 &q : strokes.allPoints())
            nearest = std::min(nearest, (p - q).norm());
        if (nearest < 0.1)
            QVERIFY(std::abs((p - t.target).norm() - nearest) < 1e-12);
    }
}

void FinishSurfaceTest::borderWithoutStrokesStays()
{
    const TriangleMesh mesh = zoo::grid(10);
    StrokeSet strokes;
    strokes.strokes = {lineAt(7.0, StrokeRole::Boundary)};
    for (const BorderAttraction &t : borderTargets(mesh, strokes, {}))
        QCOMPARE(t.target, mesh.vertices[t.vertex]);
    QCOMPARE(borderTargets(mesh, {}, {}).size(), std::size_t(40));
}

void FinishSurfaceTest::otherRolesDrawNothing()
{
    const TriangleMesh mesh = zoo::grid(10);
    for (StrokeRole role : {StrokeRole::Ignored, StrokeRole::Inner, StrokeRole::Skeletal}) {
        StrokeSet strokes;
        strokes.strokes = {lineAt(1.03, role)};
        for (const BorderAttraction &t : borderTargets(mesh, strokes, {}))
            QCOMPARE(t.target, mesh.vertices[t.vertex]);
    }
}

void FinishSurfaceTest::borderInTheMirrorPlaneIsFree()
{
    const TriangleMesh mesh = zoo::grid(10);
    std::vector<char> inPlane;
    for (const Vec3 &p : mesh.vertices)
        inPlane.push_back(p.x() == 0.0);
    const std::vector<BorderAttraction> targets = borderTargets(mesh, {}, inPlane);
    QCOMPARE(targets.size(), std::size_t(40 - 11));
    for (const BorderAttraction &t : targets)
        QVERIFY(!inPlane[t.vertex]);
}

void FinishSurfaceTest::closedMeshHasNoTargets()
{
    StrokeSet strokes;
    strokes.strokes = {lineAt(0.0, StrokeRole::Boundary)};
    QVERIFY(borderTargets(zoo::icosphere(2), strokes, {}).empty());
}

QTEST_APPLESS_MAIN(FinishSurfaceTest)
#include "finish_surface_test.moc"
