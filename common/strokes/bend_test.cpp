#include "strokes/bend.h"

#include <QtTest>
#include <cmath>

using namespace ductus;

namespace {

std::vector<Vec3> straight(int points, double length)
{
    std::vector<Vec3> line;
    for (int i = 0; i < points; ++i)
        line.push_back(length * i / (points - 1) * Vec3::UnitX());
    return line;
}

std::vector<Vec3> circle(int points)
{
    std::vector<Vec3> line;
    for (int i = 0; i <= points; ++i) {
        const double angle = 2.0 * M_PI * (i % points) / points;
        line.push_back({std::cos(angle), std::sin(angle), 0.0});
    }
    return line;
}

// Sharpest turn between two segments, radians.
double sharpestTurn(const std::vector<Vec3> &points)
{
    double sharpest = 0.0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Vec3 a = (points[i] - points[i - 1]).normalized(), b = (points[i + 1] - points[i]).normalized();
        sharpest = std::max(sharpest, std::acos(std::clamp(a.dot(b), -1.0, 1.0)));
    }
    return sharpest;
}

double nearestTo(const std::vector<Vec3> &points, const Vec3 &place)
{
    double nearest = 1e300;
    for (const Vec3 &p : points)
        nearest = std::min(nearest, (p - place).norm());
    return nearest;
}

} // namespace

class BendTest : public QObject
{
    Q_OBJECT
private slots:
    void handlesStandAtEqualSteps();
    void aClosedStrokeHasNoHandleTwice();
    void theHandleGoesWhereItIsTaken();
    void whatIsOutOfReachStays();
    void twoPointsBecomeACurve();
    void pinnedEndsStayWithTheirDirection();
    void freeEndsFollow();
    void anEndThatIsDraggedMoves();
    void aClosedStrokeStaysClosed();
    void channelsComeAlong();
    void nothingBreaksOnStrokesWithoutLength();
};

void BendTest::handlesStandAtEqualSteps()
{
    // Uneven points: the steps are of length, not of numbers.
    const std::vector<Vec3> line{Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0.2, 0, 0), Vec3(4, 0, 0)};
    const std::vector<StrokeHandle> handles = strokeHandles(line, 5);
    QCOMPARE(handles.size(), std::size_t(5));
    for (int i = 0; i < 5; ++i) {
        QVERIFY(std::abs(handles[std::size_t(i)].along - i) < 1e-12);
        QVERIFY((handles[std::size_t(i)].point - Vec3(i, 0, 0)).norm() < 1e-12);
    }
}

void BendTest::aClosedStrokeHasNoHandleTwice()
{
    const std::vector<StrokeHandle> handles = strokeHandles(circle(64), 4);
    QCOMPARE(handles.size(), std::size_t(4));
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = i + 1; k < 4; ++k)
            QVERIFY((handles[i].point - handles[k].point).norm() > 1.0);
}

void BendTest::theHandleGoesWhereItIsTaken()
{
    const std::vector<Vec3> line = straight(101, 10.0);
    const std::vector<Vec3> bent = bentLine(line, {5.0, Vec3(0, 2, 1), 3.0});
    QCOMPARE(bent.size(), line.size());
    QVERIFY((bent[50] - Vec3(5, 2, 1)).norm() < 1e-12);
    // Ever less to both sides, and without a kink: with twice the points each turns half as far.
    for (std::size_t i = 51; i < bent.size(); ++i) {
        QVERIFY(bent[i].y() <= bent[i - 1].y());
        QVERIFY(std::abs(bent[i].y() - bent[100 - i].y()) < 1e-12);
    }
    const double finer = sharpestTurn(bentLine(straight(201, 10.0), {5.0, Vec3(0, 2, 1), 3.0}));
    QVERIFY2(finer < 0.55 * sharpestTurn(bent), qPrintable(QString::number(finer)));
}

void BendTest::whatIsOutOfReachStays()
{
    const std::vector<Vec3> line = straight(101, 10.0);
    const std::vector<Vec3> bent = bentLine(line, {5.0, Vec3(0, 2, 1), 3.0});
    for (std::size_t i = 0; i < line.size(); ++i)
        QCOMPARE(bent[i] == line[i], std::abs(line[i].x() - 5.0) >= 3.0 - 1e-12);
}

void BendTest::twoPointsBecomeACurve()
{
    const std::vector<Vec3> bent = bentLine(straight(2, 10.0), {5.0, Vec3(0, 2, 0), 5.0});
    QVERIFY(bent.size() >= 20);
    QVERIFY(nearestTo(bent, Vec3(5, 2, 0)) < 0.1);
    QVERIFY(sharpestTurn(bent) < 0.3);
    QVERIFY(bent.front() == Vec3::Zero() && bent.back() == Vec3(10, 0, 0));
}

void BendTest::pinnedEndsStayWithTheirDirection()
{
    const std::vector<Vec3> line = straight(1001, 10.0);
    const std::vector<Vec3> bent = bentLine(line, {2.0, Vec3(0, 1, 0), 6.0, true});
    QVERIFY(bent.front() == line.front() && bent.back() == line.back());
    QVERIFY((bent[1] - bent[0]).normalized().dot(Vec3::UnitX()) > 0.999);
    QVERIFY((bent[200] - Vec3(2, 1, 0)).norm() < 1e-12);
    QVERIFY(bent[700].y() > 0.0); // the far side uses its reach
}

void BendTest::freeEndsFollow()
{
    const std::vector<Vec3> line = straight(101, 10.0);
    const std::vector<Vec3> bent = bentLine(line, {2.0, Vec3(0, 1, 0), 6.0, false});
    QVERIFY(bent.front().y() > 0.5);
    QVERIFY((bent[20] - Vec3(2, 1, 0)).norm() < 1e-12);
}

void BendTest::anEndThatIsDraggedMoves()
{
    const std::vector<Vec3> line = straight(101, 10.0);
    const std::vector<Vec3> start = bentLine(line, {0.0, Vec3(0, 1, 0), 4.0});
    QVERIFY((start.front() - Vec3(0, 1, 0)).norm() < 1e-12);
    QVERIFY(start.back() == line.back());
    const std::vector<Vec3> end = bentLine(line, {10.0, Vec3(0, 1, 0), 4.0});
    QVERIFY((end.back() - Vec3(10, 1, 0)).norm() < 1e-12);
    QVERIFY(end.front() == line.front());
}

void BendTest::aClosedStrokeStaysClosed()
{
    const std::vector<Vec3> line = circle(128);
    QVERIFY(isClosedLine(line));
    const double length = polylineLength(line);
    for (const double share : {0.0, 0.02, 0.5, 0.97}) {
        const StrokeBend bend{share * length, Vec3(0, 0, 0.5), 0.3 * length};
        const std::vector<Vec3> bent = bentLine(line, bend);
        QVERIFY(isClosedLine(bent));
        double highest = 0.0;
        for (const Vec3 &p : bent)
            highest = std::max(highest, p.z());
        QVERIFY(highest > 0.49 && highest <= 0.5);
        // Across the seam as smooth as elsewhere.
        std::vector<Vec3> turned(bent.begin() + std::ptrdiff_t(bent.size() / 2), bent.end() - 1);
        turned.insert(turned.end(), bent.begin(), bent.begin() + std::ptrdiff_t(bent.size() / 2));
        QVERIFY(sharpestTurn(turned) < 0.15);
    }
}

void BendTest::channelsComeAlong()
{
    Stroke stroke;
    stroke.id.value = 7;
    stroke.role = StrokeRole::Boundary;
    stroke.points = straight(3, 10.0);
    stroke.pressure = {0.0, 0.5, 1.0};
    stroke.timeSeconds = {1.0, 2.0, 3.0};
    const Stroke bent = bentStroke(stroke, {5.0, Vec3(0, 1, 0), 5.0});
    QCOMPARE(bent.id.value, 7);
    QVERIFY(bent.role == StrokeRole::Boundary);
    QVERIFY(bent.points.size() > 3);
    QCOMPARE(bent.pressure.size(), bent.points.size());
    QCOMPARE(bent.timeSeconds.size(), bent.points.size());
    for (std::size_t i = 0; i < bent.points.size(); ++i) {
        QVERIFY(std::abs(bent.pressure[i] - bent.points[i].x() / 10.0) < 1e-12);
        QVERIFY(std::abs(bent.timeSeconds[i] - (1.0 + bent.points[i].x() / 5.0)) < 1e-12);
    }
}

void BendTest::nothingBreaksOnStrokesWithoutLength()
{
    QVERIFY(strokeHandles({}, 3).empty());
    QVERIFY(strokeHandles({Vec3::Ones(), Vec3::Ones()}, 3).empty());
    QVERIFY(bentLine({}, {0.0, Vec3::Ones(), 1.0}).empty());
    const std::vector<Vec3> same{Vec3::Ones(), Vec3::Ones()};
    QVERIFY(bentLine(same, {0.0, Vec3::Ones(), 1.0}) == same);
    QVERIFY(bentLine(straight(5, 1.0), {0.5, Vec3::Ones(), 0.0}) == straight(5, 1.0));
}

QTEST_APPLESS_MAIN(BendTest)
#include "bend_test.moc"
