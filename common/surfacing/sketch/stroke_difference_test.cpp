#include "surfacing/sketch/stroke_difference.h"

#include <QtTest>

using namespace ductus;

namespace {

Stroke line(double height, StrokeRole role = StrokeRole::Surface, int id = 0)
{
    Stroke stroke;
    stroke.id.value = id;
    stroke.role = role;
    stroke.points = {{0, 0, height}, {3, 4, height}};
    return stroke;
}

StrokeSet sketchOf(std::vector<Stroke> strokes)
{
    StrokeSet set;
    set.strokes = std::move(strokes);
    return set;
}

} // namespace

class StrokeDifferenceTest : public QObject
{
    Q_OBJECT
private slots:
    void orderAndIdsAreNoChange();
    void addedAndRemovedAreFound();
    void movedStrokeIsBoth();
    void copiesAreCounted();
    void roleCounts();
    void strokesWithoutSurfaceDoNotCount();
};

void StrokeDifferenceTest::orderAndIdsAreNoChange()
{
    const StrokeSet a = sketchOf({line(1), line(2, StrokeRole::Surface, 7), line(3)});
    const StrokeSet b = sketchOf({line(3), line(1, StrokeRole::Surface, 4), line(2)});
    QVERIFY(differenceBetween(a, b).isEmpty());
    QCOMPARE(differenceBetween(a, b).length(), 0.0);
}

void StrokeDifferenceTest::addedAndRemovedAreFound()
{
    const StrokeDifference d =
        differenceBetween(sketchOf({line(9), line(1), line(2)}), sketchOf({line(5), line(1), line(4)}));
    QCOMPARE(d.removed.size(), std::size_t(2));
    QCOMPARE(d.removed[0].points[0].z(), 9.0); // in the order of the sketch, not of size
    QCOMPARE(d.removed[1].points[0].z(), 2.0);
    QCOMPARE(d.added.size(), std::size_t(2));
    QCOMPARE(d.added[0].points[0].z(), 5.0);
    QCOMPARE(d.length(), 10.0);
}

void StrokeDifferenceTest::movedStrokeIsBoth()
{
    StrokeSet moved = sketchOf({line(1), line(2)});
    moved.strokes[1].points[1].x() += 1e-6;
    const StrokeDifference d = differenceBetween(sketchOf({line(1), line(2)}), moved);
    QCOMPARE(d.removed.size(), std::size_t(1));
    QCOMPARE(d.added.size(), std::size_t(1));
    QCOMPARE(d.added[0].points, moved.strokes[1].points);
}

void StrokeDifferenceTest::copiesAreCounted()
{
    const StrokeDifference d = differenceBetween(sketchOf({line(1), line(1)}), sketchOf({line(1)}));
    QCOMPARE(d.removed.size(), std::size_t(1));
    QVERIFY(d.added.empty());
}

void StrokeDifferenceTest::roleCounts()
{
    const StrokeDifference d =
        differenceBetween(sketchOf({line(1)}), sketchOf({line(1, StrokeRole::Boundary)}));
    QCOMPARE(d.removed.size(), std::size_t(1));
    QCOMPARE(d.added.size(), std::size_t(1));
    QVERIFY(d.hasBoundaryStrokes());
    QVERIFY(!differenceBetween(sketchOf({line(1)}), sketchOf({})).hasBoundaryStrokes());
}

void StrokeDifferenceTest::strokesWithoutSurfaceDoNotCount()
{
    QVERIFY(
        differenceBetween(sketchOf({line(1)}), sketchOf({line(1), line(2, StrokeRole::Inner)})).isEmpty());
    // One that is ignored from now on is gone.
    QCOMPARE(differenceBetween(sketchOf({line(1)}), sketchOf({line(1, StrokeRole::Ignored)})).removed.size(),
             std::size_t(1));
}

QTEST_GUILESS_MAIN(StrokeDifferenceTest)
#include "stroke_difference_test.moc"
