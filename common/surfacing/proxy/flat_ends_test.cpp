#include "surfacing/proxy/flat_ends.h"

#include "strokes/resample.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numbers>

using namespace ductus;

namespace {

constexpr double radius = 0.15, height = 0.7;

Stroke arc(double r, double y, double fromTurn, double toTurn)
{
    Stroke stroke;
    for (int i = 0; i <= 48; ++i) {
        const double a = 2.0 * std::numbers::pi * (fromTurn + (toTurn - fromTurn) * i / 48.0);
        stroke.points.push_back({r * std::cos(a), y, r * std::sin(a)});
    }
    return stroke;
}

Stroke line(const Vec3 &a, const Vec3 &b)
{
    Stroke stroke;
    stroke.points = {a, b};
    return stroke;
}

// Side of a round tin that stands on y = 0: rings between the ends, and lines up the side.
StrokeSet tinSide()
{
    StrokeSet set;
    for (int i = 0; i < 8; ++i) {
        const double a = 2.0 * std::numbers::pi * i / 8;
        const Vec3 foot(radius * std::cos(a), 0.0, radius * std::sin(a));
        set.strokes.push_back(line(foot, foot + height * Vec3::UnitY()));
    }
    set.strokes.push_back(arc(radius, 0.3, 0.0, 1.0));
    return set;
}

std::vector<FlatEnd> endsOf(const StrokeSet &set)
{
    std::vector<Vec3> points;
    for (const Stroke &stroke : set.strokes) {
        const std::vector<Vec3> even = resampled(stroke.points, 0.008);
        points.insert(points.end(), even.begin(), even.end());
    }
    const Result<Wrap> wrap = wrapStrokes(points, {}, {});
    if (!wrap)
        throw std::runtime_error(wrap.error().message());
    return flatEndsOf(set, *wrap, {});
}

} // namespace

class FlatEndsTest : public QObject
{
    Q_OBJECT

private slots:
    void outlinesWithNothingInsideAreFlat()
    {
        StrokeSet set = tinSide();
        set.strokes.push_back(arc(radius, 0.0, 0.0, 1.05));
        set.strokes.push_back(arc(radius, height, 0.0, 0.97));
        const std::vector<FlatEnd> ends = endsOf(set);
        QCOMPARE(ends.size(), std::size_t(2));
        for (const FlatEnd &end : ends) {
            const bool isTop = end.centre.y() > 0.5 * height;
            QVERIFY((end.outwards - (isTop ? 1.0 : -1.0) * Vec3::UnitY()).norm() < 0.02);
            QVERIFY(end.inside.size() > 50);
            for (const Vec3 &p : end.inside) {
                QVERIFY(std::abs(p.y() - (isTop ? height : 0.0)) < 1e-3);
                QVERIFY(std::hypot(p.x(), p.z()) < radius);
            }
        }
    }

    void outlineOfSeveralStrokesIsOne()
    {
        StrokeSet set = tinSide();
        for (double turn : {0.0, 0.33, 0.66})
            set.strokes.push_back(arc(radius, 0.0, turn, turn + 0.35));
        QCOMPARE(endsOf(set).size(), std::size_t(1));
    }

    // No stroke of the floor of this trough shows its plane alone, but all stand on the hull.
    void floorsThatStraightStrokesStandOnAreFlat()
    {
        const double length = 0.8, width = 0.4, high = 0.25;
        const auto trough = [&] {
            StrokeSet set;
            for (const double y : {0.0, high})
                for (const double side : {-0.5, 0.5}) {
                    set.strokes.push_back(
                        line({-0.5 * length, y, side * width}, {0.5 * length, y, side * width}));
                    set.strokes.push_back(
                        line({side * length, y, -0.5 * width}, {side * length, y, 0.5 * width}));
                }
            for (int i = 0; i <= 4; ++i) // over the top, so that it is no floor
                for (const double side : {-0.5, 0.5}) {
                    const double x = (0.25 * i - 0.5) * length;
                    set.strokes.push_back(line({x, 0.0, side * width}, {x, high, side * width}));
                    set.strokes.push_back(line({x, high, side * width}, {x, high + 0.1, 0.0}));
                }
            return set;
        };
        const auto floors = [](const std::vector<FlatEnd> &ends) {
            return std::count_if(ends.begin(), ends.end(),
                                 [](const FlatEnd &end) { return end.outwards.y() < -0.99; });
        };
        const StrokeSet set = trough();
        const std::vector<FlatEnd> ends = endsOf(set);
        QCOMPARE(floors(ends), 1);
        for (const FlatEnd &end : ends)
            if (end.outwards.y() < -0.99)
                for (const Vec3 &p : end.inside)
                    QVERIFY(std::abs(p.y()) < 1e-3);

        StrokeSet dented = trough();
        Stroke dent;
        for (int i = 0; i <= 40; ++i)
            dent.points.push_back(
                {(0.025 * i - 0.5) * length, 0.08 * std::sin(std::numbers::pi * i / 40), 0.0});
        dented.strokes.push_back(dent);
        QCOMPARE(floors(endsOf(dented)), 0);
    }

    void profilesAcrossMakeItADome()
    {
        StrokeSet set = tinSide();
        set.strokes.push_back(arc(radius, height, 0.0, 1.0));
        Stroke profile;
        for (int i = 0; i <= 40; ++i) {
            const double a = std::numbers::pi * i / 40;
            profile.points.push_back({radius * std::cos(a), height + 0.6 * radius * std::sin(a), 0.0});
        }
        set.strokes.push_back(profile);
        QVERIFY(endsOf(set).empty());
    }

    void crossSectionsWithinASolidAreNoEnds() { QVERIFY(endsOf(tinSide()).empty()); }

    void halfAnOutlineIsNoEnd()
    {
        StrokeSet set = tinSide();
        set.strokes.push_back(arc(radius, 0.0, 0.0, 0.6));
        QVERIFY(endsOf(set).empty());
    }

    void strokesDrawnLaterMayContradict()
    {
        StrokeSet set = tinSide();
        set.strokes.push_back(arc(radius, 0.0, 0.0, 1.0));
        const std::vector<FlatEnd> ends = endsOf(set);
        QCOMPARE(ends.size(), std::size_t(1));
        QCOMPARE(stillFlat(ends, {{0.0, -0.05, 0.0}}, {}).size(), std::size_t(0));
        QCOMPARE(stillFlat(ends, {{0.0, 0.002, 0.0}}, {}).size(), std::size_t(1));
        QCOMPARE(stillFlat(ends, {{0.5, -0.05, 0.0}}, {}).size(), std::size_t(1));
    }
};

QTEST_APPLESS_MAIN(FlatEndsTest)
#include "flat_ends_test.moc"
