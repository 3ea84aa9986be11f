#include "surfacing/parts/cable_proposal.h"

#include "support/box_sketch.h"

#include <QtTest>
#include <atomic>

using namespace ductus;

namespace {

// A box, and 1.5 to its right a plug: a smaller box, far from it.
StrokeSet boxAndPlug()
{
    StrokeSet sketch = boxSketch({Vec3(0.4, 0.4, 0.4)});
    const std::size_t count = sketch.strokes.size();
    for (std::size_t s = 0; s < count; ++s) {
        Stroke stroke = sketch.strokes[s];
        for (Vec3 &p : stroke.points)
            p = 0.25 * p + Vec3(1.9, 0.3, 0.0);
        sketch.strokes.push_back(stroke);
    }
    return sketch;
}

Stroke line(const std::vector<Vec3> &corners)
{
    Stroke stroke;
    stroke.points = corners;
    return stroke;
}

std::vector<int> cablesOf(const StrokeSet &strokes)
{
    const Result<std::vector<int>> cables = proposedCables(strokes, {}, {});
    return cables ? *cables : std::vector<int>{-1};
}

} // namespace

class CableProposalTest : public QObject
{
    Q_OBJECT
private slots:
    void bridgeBetweenBodies();
    void cableWithAFreeEnd();
    void edgesOfABoxAreNone();
    void twoWaysBetweenBodiesAreNone();
    void rolesByHandStay();
    void cancels();
};

void CableProposalTest::bridgeBetweenBodies()
{
    StrokeSet sketch = boxAndPlug();
    QCOMPARE(cablesOf(sketch), std::vector<int>());
    sketch.strokes.push_back(line({{0.4, 0.4, 0.4}, {1.0, 0.7, 0.2}, {1.8, 0.4, 0.1}}));
    QCOMPARE(cablesOf(sketch), std::vector<int>{int(sketch.strokes.size()) - 1});
    // Wherever the sketch is and however large.
    for (Stroke &stroke : sketch.strokes)
        for (Vec3 &p : stroke.points)
            p = 1000.0 * p + Vec3(3e4, 0, -2e4);
    QCOMPARE(cablesOf(sketch), std::vector<int>{int(sketch.strokes.size()) - 1});
}

void CableProposalTest::cableWithAFreeEnd()
{
    StrokeSet sketch = boxSketch({Vec3(0.4, 0.4, 0.4)});
    const int cable = int(sketch.strokes.size());
    sketch.strokes.push_back(line({{0.4, 0.4, 0.4}, {1.0, 0.9, 0.4}, {2.0, 0.9, 0.6}}));
    QCOMPARE(cablesOf(sketch), std::vector<int>{cable});
    sketch.strokes.back() = line({{0.4, 0.4, 0.4}, {0.5, 0.5, 0.4}}); // a stub
    QCOMPARE(cablesOf(sketch), std::vector<int>());
    sketch.strokes.back() = line({{1.4, 0.4, 0.4}, {2.5, 0.5, 0.4}}); // hangs on nothing
    QCOMPARE(cablesOf(sketch), std::vector<int>());
}

void CableProposalTest::edgesOfABoxAreNone()
{
    // Twelve edges and nothing else: each as alone as a cable.
    StrokeSet sketch;
    for (int axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 4; ++corner) {
            Vec3 a = Vec3::Zero();
            a[(axis + 1) % 3] = corner & 1;
            a[(axis + 2) % 3] = corner >> 1;
            sketch.strokes.push_back(line({a, a + Vec3::Unit(axis)}));
        }
    QCOMPARE(cablesOf(sketch), std::vector<int>());
}

void CableProposalTest::twoWaysBetweenBodiesAreNone()
{
    // Two lines from body to body hold a sheet between them.
    StrokeSet sketch = boxAndPlug();
    sketch.strokes.push_back(line({{0.4, 0.4, 0.4}, {1.8, 0.4, 0.1}}));
    sketch.strokes.push_back(line({{0.4, -0.4, 0.4}, {1.8, 0.2, 0.1}}));
    QCOMPARE(cablesOf(sketch), std::vector<int>());
}

void CableProposalTest::rolesByHandStay()
{
    StrokeSet sketch = boxAndPlug();
    sketch.strokes.push_back(line({{0.4, 0.4, 0.4}, {1.8, 0.4, 0.1}}));
    for (StrokeRole role : {StrokeRole::Boundary, StrokeRole::Ignored, StrokeRole::Skeletal}) {
        sketch.strokes.back().role = role;
        QCOMPARE(cablesOf(sketch), std::vector<int>());
    }
    QCOMPARE(cablesOf({}), std::vector<int>());
}

void CableProposalTest::cancels()
{
    const std::atomic<bool> cancelled = true;
    const Result<std::vector<int>> cables = proposedCables(boxAndPlug(), {}, JobControl(&cancelled, {}));
    QVERIFY(!cables.ok() && cables.error().isCancelled());
}

QTEST_APPLESS_MAIN(CableProposalTest)
#include "cable_proposal_test.moc"
