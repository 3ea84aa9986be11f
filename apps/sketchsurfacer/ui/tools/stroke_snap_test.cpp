#include "sketchsurfacer/ui/tools/stroke_snap.h"

#include <QtTest>
#include <cmath>

using namespace ductus;

class StrokeSnapTest : public QObject
{
    Q_OBJECT
private slots:
    void aLineBetweenStrokesIsLiftedAllAlong();
    void anchorsOnTheWayAreMet();
    void oneEndFadesOut();
    void withoutAnchorsNothingMoves();
    void whatSagsBetweenStrokesIsPulledStraight();
};

namespace {

std::vector<Vec3> flatLine()
{
    std::vector<Vec3> points;
    for (int i = 0; i <= 10; ++i)
        points.push_back({double(i), 0.0, 0.0});
    return points;
}

} // namespace

void StrokeSnapTest::aLineBetweenStrokesIsLiftedAllAlong()
{
    const std::vector<Vec3> line = carriedTo(flatLine(), {{0, {0, 1, 0}}, {10, {10, 2, 0}}}, 1.0);
    for (int i = 0; i <= 10; ++i)
        QVERIFY((line[std::size_t(i)] - Vec3(i, 1.0 + 0.1 * i, 0.0)).norm() < 1e-12);
}

void StrokeSnapTest::anchorsOnTheWayAreMet()
{
    const std::vector<Vec3> line =
        carriedTo(flatLine(), {{0, {0, 0, 0}}, {4, {4, 1, 0}}, {10, {10, 0, 0}}}, 1.0);
    QCOMPARE(line[4].y(), 1.0);
    QCOMPARE(line[2].y(), 0.5);
    QCOMPARE(line[7].y(), 0.5);
    QCOMPARE(line[10].y(), 0.0);
}

void StrokeSnapTest::oneEndFadesOut()
{
    const std::vector<Vec3> line = carriedTo(flatLine(), {{0, {0, 1, 0}}}, 4.0);
    QCOMPARE(line[0].y(), 1.0);
    QVERIFY(line[1].y() < line[0].y() && line[2].y() < line[1].y());
    for (int i = 4; i <= 10; ++i)
        QCOMPARE(line[std::size_t(i)].y(), 0.0);
    const std::vector<Vec3> other = carriedTo(flatLine(), {{10, {10, 1, 0}}}, 4.0);
    QCOMPARE(other[10].y(), 1.0);
    QCOMPARE(other[5].y(), 0.0);
}

void StrokeSnapTest::whatSagsBetweenStrokesIsPulledStraight()
{
    const std::vector<SnapAnchor> anchors{{0, {0, 0, 0}}, {10, {10, 0, 0}}};
    const Vec3 eye(5, 1000, 0); // far above
    std::vector<Vec3> sagging = flatLine(), bulging = flatLine(), hollow = flatLine();
    for (std::size_t i = 1; i < 10; ++i) {
        const double bow = std::sin(0.314159 * double(i));
        sagging[i].y() -= bow;
        bulging[i].y() += bow;
        hollow[i].y() -= 4.0 * bow;
    }
    for (const Vec3 &p : withoutSag(sagging, anchors, eye, 0.2))
        QVERIFY(std::abs(p.y()) < 1e-3);
    QVERIFY(withoutSag(bulging, anchors, eye, 0.2) == bulging);
    QVERIFY(withoutSag(hollow, anchors, eye, 0.2) == hollow);
}

void StrokeSnapTest::withoutAnchorsNothingMoves()
{
    QVERIFY(carriedTo(flatLine(), {}, 1.0) == flatLine());
    QVERIFY(carriedTo({}, {}, 1.0).empty());
}

QTEST_GUILESS_MAIN(StrokeSnapTest)
#include "stroke_snap_test.moc"
