#include "strokes/resample.h"

#include <QtTest>

using namespace ductus;

class ResampleTest : public QObject
{
    Q_OBJECT
private slots:
    void samplesAreEvenAndKeepBothEnds();
    void channelsFollowThePoints();
    void strokeWithoutLengthGivesOnePoint();
    void cleaningDropsRepeatsShortStrokesAndDuplicates();
};

void ResampleTest::samplesAreEvenAndKeepBothEnds()
{
    const std::vector<Vec3> corner{{0, 0, 0}, {1, 0, 0}, {1, 2.05, 0}};
    const std::vector<Vec3> even = resampled(corner, 0.1);
    QCOMPARE(int(even.size()), 32);
    QCOMPARE(even.front(), corner.front());
    QCOMPARE(even.back(), corner.back());
    for (std::size_t i = 1; i < even.size(); ++i)
        QVERIFY((even[i] - even[i - 1]).norm() <= 0.1 + 1e-12);
}

void ResampleTest::channelsFollowThePoints()
{
    Stroke stroke;
    stroke.points = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
    stroke.pressure = {0.0, 0.5, 0.5};
    stroke.timeSeconds = {10.0, 11.0, 13.0};
    const Stroke even = resampled(stroke, 0.5);
    QCOMPARE(even.points.size(), even.pressure.size());
    for (std::size_t i = 0; i < even.points.size(); ++i) {
        QVERIFY(std::abs(even.timeSeconds[i] - (10.0 + even.points[i].x())) < 1e-12);
        QVERIFY(std::abs(even.pressure[i] - std::min(0.5, 0.5 * even.points[i].x())) < 1e-12);
    }
}

void ResampleTest::strokeWithoutLengthGivesOnePoint()
{
    QCOMPARE(int(resampled(std::vector<Vec3>{{1, 1, 1}, {1, 1, 1}}, 0.1).size()), 1);
}

void ResampleTest::cleaningDropsRepeatsShortStrokesAndDuplicates()
{
    StrokeSet set;
    Stroke line;
    line.id = {0};
    line.points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
    Stroke reversed;
    reversed.id = {1};
    reversed.points = {{1, 0, 0}, {0, 0, 0}};
    Stroke dot;
    dot.id = {2};
    dot.points = {{2, 2, 2}, {2, 2, 2}};
    Stroke other;
    other.id = {3};
    other.points = {{1, 0, 0}, {0, 1, 0}};
    set.strokes = {line, reversed, dot, other};
    const StrokeSet result = cleaned(set);
    QCOMPARE(int(result.strokes.size()), 2);
    QCOMPARE(result.strokes[0].id.value, 0);
    QCOMPARE(int(result.strokes[0].points.size()), 2);
    QCOMPARE(result.strokes[1].id.value, 3);
}

QTEST_APPLESS_MAIN(ResampleTest)
#include "resample_test.moc"
