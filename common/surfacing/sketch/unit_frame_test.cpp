#include "surfacing/sketch/unit_frame.h"

#include "base/random.h"
#include "support/mesh_zoo.h"

#include <QtTest>

using namespace ductus;

namespace {

StrokeSet randomSketch(const Vec3 &centre, double size)
{
    Random random(3);
    StrokeSet set;
    for (int s = 0; s < 6; ++s) {
        Stroke stroke;
        stroke.id.value = s;
        for (int i = 0; i < 10; ++i) {
            const double x = random.uniform(-size, size), y = random.uniform(-size, size);
            stroke.points.push_back(centre + Vec3(x, y, random.uniform(-size, size)));
        }
        set.strokes.push_back(stroke);
    }
    return set;
}

} // namespace

class UnitFrameTest : public QObject
{
    Q_OBJECT
private slots:
    void boxBecomesUnit_data();
    void boxBecomesUnit();
    void roundTrip();
    void planesMoveWithTheirPoints();
    void onlySurfaceStrokesSetTheFrame();
    void nothingDegenerate();
};

void UnitFrameTest::boxBecomesUnit_data()
{
    QTest::addColumn<double>("size");
    QTest::addColumn<double>("away");
    QTest::addRow("metres") << 1.0 << 0.0;
    QTest::addRow("millimetres far from the origin") << 400.0 << 20000.0;
    QTest::addRow("tiny") << 1e-4 << 3.0;
}

void UnitFrameTest::boxBecomesUnit()
{
    QFETCH(double, size);
    QFETCH(double, away);
    const StrokeSet sketch = randomSketch({away, -2 * away, away}, size);
    const StrokeSet unit = inUnitFrame(sketch, unitFrameOf(sketch));
    QVERIFY(std::abs(unit.box().diagonal() - 1.0) < 1e-7);
    QVERIFY(unit.box().centre().norm() < 1e-7);
    QCOMPARE(unit.strokes.size(), sketch.strokes.size());
    QCOMPARE(unit.strokes[4].id.value, 4);
}

void UnitFrameTest::roundTrip()
{
    const StrokeSet sketch = randomSketch({5, 6, 7}, 2.0);
    const UnitFrame frame = unitFrameOf(sketch);
    for (const Vec3 &p : sketch.allPoints())
        QVERIFY((frame.inputFromUnit(frame.unitFromInput(p)) - p).norm() < 1e-13);
    const TriangleMesh ball = zoo::icosphere(1);
    const TriangleMesh back = inInputFrame(inUnitFrame(ball, frame), frame);
    QVERIFY(back.triangles == ball.triangles);
    for (int v = 0; v < ball.vertexCount(); ++v)
        QVERIFY((back.vertices[v] - ball.vertices[v]).norm() < 1e-13);
}

void UnitFrameTest::planesMoveWithTheirPoints()
{
    const UnitFrame frame{{3, -1, 2}, 5.0};
    const SymmetryPlane plane{Vec3(1, 2, -2) / 3.0, 0.7};
    const SymmetryPlane unit = frame.unitFromInput(plane);
    for (const Vec3 &p : {Vec3(0, 0, 0), Vec3(3, -1, 2), Vec3(-4, 8, 1)}) {
        QVERIFY(std::abs(unit.signedDistance(frame.unitFromInput(p)) - plane.signedDistance(p) / 5.0) <
                1e-14);
        QVERIFY((frame.inputFromUnit(unit.mirrored(frame.unitFromInput(p))) - plane.mirrored(p)).norm() <
                1e-13);
    }
}

void UnitFrameTest::onlySurfaceStrokesSetTheFrame()
{
    StrokeSet sketch = randomSketch(Vec3::Zero(), 1.0);
    const UnitFrame before = unitFrameOf(sketch);
    Stroke far;
    far.points = {{50, 50, 50}, {60, 60, 60}};
    for (StrokeRole role : {StrokeRole::Ignored, StrokeRole::Inner, StrokeRole::Skeletal}) {
        far.role = role;
        sketch.strokes.push_back(far);
    }
    QCOMPARE(unitFrameOf(sketch).diagonal, before.diagonal);
    QCOMPARE(unitFrameOf(sketch).centre, before.centre);
    far.role = StrokeRole::Boundary;
    sketch.strokes.push_back(far);
    QVERIFY(unitFrameOf(sketch).diagonal > 80.0);
}

void UnitFrameTest::nothingDegenerate()
{
    StrokeSet point;
    point.strokes.resize(1);
    point.strokes[0].points = {{4, 5, 6}, {4, 5, 6}};
    for (const StrokeSet &set : {StrokeSet(), point}) {
        const UnitFrame frame = unitFrameOf(set);
        QVERIFY(frame.diagonal > 0.0 && frame.centre.allFinite());
        for (const Vec3 &p : inUnitFrame(set, frame).allPoints())
            QVERIFY(p.allFinite());
    }
}

QTEST_APPLESS_MAIN(UnitFrameTest)
#include "unit_frame_test.moc"
