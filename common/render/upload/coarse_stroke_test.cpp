#include "render/upload/coarse_stroke.h"

#include <QtTest>
#include <cmath>

using namespace ductus;

class CoarseStrokeTest : public QObject
{
    Q_OBJECT
private slots:
    void aStraightEvenStrokeKeepsItsEnds();
    void bendsStay();
    void colourAndWidthStay();
    void shortStrokesStayWhole();
};

namespace {

StrokeShape wave(int points, float height)
{
    StrokeShape stroke;
    for (int i = 0; i < points; ++i) {
        const float x = float(i) / float(points - 1);
        stroke.points.push_back({{x, height * std::sin(12 * x), 0}, {0, 0, 1}, 0.02f, {0.5f, 0.5f, 0.5f}, 1});
    }
    return stroke;
}

/// The greatest distance of the points of \a fine from the line through those of \a coarse.
double distance(const StrokeShape &fine, const StrokeShape &coarse)
{
    float most = 0;
    for (const PaintedPoint &point : fine.points) {
        float least = 1e9f;
        for (std::size_t i = 0; i + 1 < coarse.points.size(); ++i) {
            const Eigen::Vector3f a = coarse.points[i].position, d = coarse.points[i + 1].position - a;
            const float t = std::clamp((point.position - a).dot(d) / d.squaredNorm(), 0.f, 1.f);
            least = std::min(least, (point.position - a - t * d).norm());
        }
        most = std::max(most, least);
    }
    return double(most);
}

} // namespace

void CoarseStrokeTest::aStraightEvenStrokeKeepsItsEnds()
{
    const CoarseStroke coarse = coarseStroke(wave(100, 0));
    QCOMPARE(coarse.shape.points.size(), 2u);
    QCOMPARE(coarse.shape.points[1].position.x(), 1.f);
    QCOMPARE(coarse.error, 0.5 * double(0.02f));
}

void CoarseStrokeTest::bendsStay()
{
    const StrokeShape fine = wave(200, 0.2f);
    const CoarseStroke coarse = coarseStroke(fine);
    QVERIFY(coarse.shape.points.size() < 60);
    QVERIFY(distance(fine, coarse.shape) <= coarse.error * 1.001);
}

void CoarseStrokeTest::colourAndWidthStay()
{
    StrokeShape stroke = wave(50, 0);
    stroke.points[20].colour = {1, 0, 0};
    stroke.points[30].halfWidth = 0.2f; // widest: the error grows with it, and still this is more
    const CoarseStroke coarse = coarseStroke(stroke);
    bool red = false, wide = false;
    for (const PaintedPoint &point : coarse.shape.points) {
        red |= point.colour.x() == 1;
        wide |= point.halfWidth == 0.2f;
    }
    QVERIFY(red && wide);
    QVERIFY(coarse.shape.points.size() < 12);
}

void CoarseStrokeTest::shortStrokesStayWhole()
{
    QCOMPARE(coarseStroke(wave(2, 0)).shape.points.size(), 2u);
    StrokeShape dab = wave(2, 0);
    dab.points.resize(1);
    QCOMPARE(coarseStroke(dab).shape.points.size(), 1u);
    QVERIFY(coarseStroke({}).shape.points.empty());
}

QTEST_APPLESS_MAIN(CoarseStrokeTest)
#include "coarse_stroke_test.moc"
