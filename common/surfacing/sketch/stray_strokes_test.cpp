#include "surfacing/sketch/stray_strokes.h"

#include <QtTest>

using namespace ductus;

namespace {

Stroke line(const Vec3 &from, const Vec3 &to)
{
    Stroke stroke;
    for (int i = 0; i <= 20; ++i)
        stroke.points.push_back(from + (to - from) * (i / 20.0));
    return stroke;
}

// Twelve edges of a unit cube.
StrokeSet cube()
{
    StrokeSet set;
    for (int axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 4; ++corner) {
            Vec3 from = Vec3::Zero();
            from[(axis + 1) % 3] = corner & 1;
            from[(axis + 2) % 3] = corner >> 1;
            set.strokes.push_back(line(from, from + Vec3::Unit(axis)));
        }
    return set;
}

Stroke dab(const Vec3 &at)
{
    return line(at, at + Vec3(0.01, 0.0, 0.005));
}

std::vector<int> ignored(const StraysFound &found)
{
    std::vector<int> result;
    for (std::size_t s = 0; s < found.strokes.strokes.size(); ++s)
        if (found.strokes.strokes[s].role == StrokeRole::Ignored)
            result.push_back(int(s));
    return result;
}

} // namespace

class StrayStrokesTest : public QObject
{
    Q_OBJECT
private slots:
    void dabsInTheAirAreIgnored()
    {
        StrokeSet set = cube();
        set.strokes.push_back(dab({1.6, 1.0, 1.0}));
        set.strokes.push_back(dab({0.5, 0.04, 0.0}));  // a detail on an edge
        set.strokes.push_back(dab({1.61, 1.01, 1.0})); // beside the first one: still far from the cube
        const StraysFound found = withStraysIgnored(set);
        QCOMPARE(ignored(found), (std::vector<int>{12, 14}));
        QCOMPARE(found.count, 2);
    }
    void longStrokesFarAwayAreDrawn()
    {
        StrokeSet set = cube();
        set.strokes.push_back(line({1.6, 1.0, 1.0}, {1.9, 1.0, 1.0}));
        QCOMPARE(withStraysIgnored(set).count, 0);
    }
    void rolesGivenByHandStay()
    {
        StrokeSet set = cube();
        set.strokes.push_back(dab({1.6, 1.0, 1.0}));
        set.strokes.back().role = StrokeRole::Boundary;
        QCOMPARE(withStraysIgnored(set).count, 0);
        QVERIFY(withStraysIgnored(set).strokes.strokes.back().role == StrokeRole::Boundary);
    }
    void sketchesOfDabsAreKept()
    {
        StrokeSet set = cube();
        for (int i = 0; i < 30; ++i)
            set.strokes.push_back(dab(Vec3(1.3 + 0.1 * i, 0.5, 0.5)));
        QCOMPARE(withStraysIgnored(set).count, 0);
    }
    void nothingAndOneStroke()
    {
        QCOMPARE(withStraysIgnored({}).count, 0);
        StrokeSet one;
        one.strokes.push_back(dab(Vec3::Zero()));
        QCOMPARE(withStraysIgnored(one).count, 0);
    }
};

QTEST_APPLESS_MAIN(StrayStrokesTest)
#include "stray_strokes_test.moc"
