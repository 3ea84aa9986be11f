#include "surfacing/proxy/outline.h"

#include <QtTest>
#include <cmath>
#include <numbers>

using namespace ductus;

namespace {

constexpr OutlineDemands demands{0.9, 0.06};

// Sides of a rectangle in z = 0.2, without what lies between the turns where nothing is drawn.
std::vector<Vec3> rectangle(double halfLength, double halfWidth, double gapFrom = 0.0, double gapTo = 0.0)
{
    std::vector<Vec3> points;
    const auto add = [&](double x, double y) {
        const double turn = std::atan2(y, x) / (2.0 * std::numbers::pi) + 0.5;
        if (turn < gapFrom || turn > gapTo)
            points.push_back({x, y, 0.2});
    };
    for (int i = -200; i <= 200; ++i)
        for (const double side : {-1.0, 1.0}) {
            add(halfLength * i / 200, side * halfWidth);
            add(side * halfLength, halfWidth * i / 200);
        }
    return points;
}

} // namespace

class OutlineTest : public QObject
{
    Q_OBJECT

private slots:
    void planeRunsAlongThePoints()
    {
        const OutlinePlane plane = planeThrough(rectangle(0.4, 0.2));
        QVERIFY((plane.centre - Vec3(0, 0, 0.2)).norm() < 1e-12);
        QVERIFY(std::abs(std::abs(plane.normal.z()) - 1.0) < 1e-12);
        QVERIFY(std::abs(plane.halfWidth - 0.4) < 1e-12);
        QVERIFY(std::abs(plane.lesserHalfWidth - 0.2) < 1e-12);
        QVERIFY(plane.meanDistance < 1e-12);
    }

    void insideIsFilledEvenly()
    {
        const std::optional<Outline> outline = outlineThrough(rectangle(0.4, 0.2), demands);
        QVERIFY(outline.has_value());
        const std::vector<Vec3> inside = pointsInside(*outline, 0.02);
        const double expected = 0.92 * 0.92 * 0.32 / (0.02 * 0.02 * 0.866);
        QVERIFY(std::abs(double(inside.size()) - expected) < 0.1 * expected);
        for (const Vec3 &p : inside)
            QVERIFY(std::abs(p.x()) < 0.4 && std::abs(p.y()) < 0.2 && std::abs(p.z() - 0.2) < 1e-12);
    }

    void gapsAreClosedStraight()
    {
        const std::vector<Vec3> points = rectangle(0.4, 0.2, 0.71, 0.79); // in the middle of a long side
        QVERIFY(!outlineThrough(points, {0.95, 0.2}).has_value());
        QVERIFY(!outlineThrough(points, {0.6, 0.05}).has_value());
        const std::optional<Outline> outline = outlineThrough(points, {0.6, 0.2});
        QVERIFY(outline.has_value());
        const auto radius = [&](const Vec3 &p) { return outline->radiusTowards(outline->plane.across(p)); };
        const double offMiddle = outline->plane.centre.y(); // the gap moves the middle away from it
        QVERIFY(std::abs(radius({0.0, 0.2, 0.2}) - (0.2 - offMiddle)) < 0.01);
    }

    void tanglesAreNoOutlines()
    {
        std::vector<Vec3> points = rectangle(0.4, 0.2);
        for (const Vec3 &p : rectangle(0.2, 0.1))
            points.push_back(p);
        QVERIFY(!outlineThrough(points, demands).has_value());
    }
};

QTEST_GUILESS_MAIN(OutlineTest)
#include "outline_test.moc"
