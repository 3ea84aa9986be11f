#include "surfacing/proxy/hull_outlines.h"

#include <QtTest>
#include <cmath>

using namespace ductus;

namespace {

std::vector<Vec3> line(const Vec3 &a, const Vec3 &b)
{
    std::vector<Vec3> points;
    for (int i = 0; i <= 50; ++i)
        points.push_back(a + i / 50.0 * (b - a));
    return points;
}

// A roof over four sills: the sills lie in y = 0, as no stroke shows alone.
std::vector<std::vector<Vec3>> tent()
{
    const Vec3 a(-0.4, 0, -0.2), b(0.4, 0, -0.2), c(0.4, 0, 0.2), d(-0.4, 0, 0.2), top(0.0, 0.3, 0.0);
    return {line(a, b),   line(b, c),   line(c, d),   line(d, a),
            line(a, top), line(b, top), line(c, top), line(d, top)};
}

} // namespace

class HullOutlinesTest : public QObject
{
    Q_OBJECT

private slots:
    void floorIsFoundFromItsSills()
    {
        const std::vector<HullOutline> outlines = outlinesOnHull(tent(), 0.01, 0.0025);
        QVERIFY(!outlines.empty());
        QVERIFY((outlines.front().outwards + Vec3::UnitY()).norm() < 1e-6);
        QCOMPARE(outlines.front().points.size(), std::size_t(4 * 51));
    }

    void everyPlaneComesOnce()
    {
        const std::vector<HullOutline> outlines = outlinesOnHull(tent(), 0.01, 0.0025);
        QCOMPARE(outlines.size(), std::size_t(5));
        for (const HullOutline &outline : outlines)
            for (const Vec3 &p : outline.points) // the hull has all on one side
                for (const HullOutline &other : outlines)
                    QVERIFY(other.outwards.dot(p - other.points.front()) < 1e-6);
    }

    void flatSketchesHaveNone()
    {
        QVERIFY(
            outlinesOnHull({line({0, 0, 0}, {1, 0, 0}), line({0, 1, 0}, {1, 1, 0})}, 0.01, 0.0025).empty());
    }
};

QTEST_GUILESS_MAIN(HullOutlinesTest)
#include "hull_outlines_test.moc"
