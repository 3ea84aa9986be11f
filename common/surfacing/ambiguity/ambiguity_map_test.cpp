#include "surfacing/ambiguity/ambiguity_map.h"

#include "support/mesh_zoo.h"
#include "surfacing/ambiguity/alternatives.h"

#include <QtTest>

using namespace ductus;

namespace {

constexpr int cells = 40; // of the unit sheet along each side

ImplicitPolynomial planeAt(double height)
{
    ImplicitPolynomial plane;
    plane.theta = Eigen::VectorXd::Zero(4);
    plane.theta << -height, 0.0, 0.0, 1.0;
    return plane;
}

struct Sheet
{
    TriangleMesh mesh = zoo::grid(cells);
    MeshTopology topology{mesh};

    // Two regions that meet at x = \a border, flat at those heights.
    LabelSample divided(double border, double left = 0.0, double right = 0.0, double weight = 1.0) const
    {
        LabelSample sample;
        for (const Vec3 &p : mesh.vertices)
            sample.segmentation.labels.push_back(p.x() > border ? 1 : 0);
        sample.segmentation.models = {planeAt(left), planeAt(right)};
        sample.segmentation.energy = 1.0;
        sample.weight = weight;
        return sample;
    }

    // Extremes among vertices whose x lies in the range.
    std::pair<double, double> range(const std::vector<double> &values, double from, double to) const
    {
        double least = 1e300, most = -1e300;
        for (std::size_t v = 0; v < values.size(); ++v)
            if (mesh.vertices[v].x() >= from && mesh.vertices[v].x() <= to) {
                least = std::min(least, values[v]);
                most = std::max(most, values[v]);
            }
        return {least, most};
    }
};

const Sheet &sheet()
{
    static const Sheet made;
    return made;
}

AmbiguityMap mapOf(const std::vector<LabelSample> &samples)
{
    return ambiguityOf(sheet().mesh, sheet().topology, samples, {});
}

} // namespace

class AmbiguityMapTest : public QObject
{
    Q_OBJECT
private slots:
    void sheetIsTheUnitSquare();
    void agreementIsNone();
    void borderInHalfOfTheSamplesIsFull();
    void weightsCount();
    void smallShiftsAreNoDisagreement();
    void surfacesApartAreSeen();
    void surfaceSpreadIsMeasured();
    void wildModelsAreBounded();
    void nearBorderWalksThatFar();
    void borderDifferenceIsALength();
    void alternativesAreDifferentAndGood();
    void alternativesDifferFromOneAnother();
};

void AmbiguityMapTest::sheetIsTheUnitSquare()
{
    const Box3 box = boundingBox(sheet().mesh.vertices);
    QCOMPARE(box.min.x(), 0.0);
    QCOMPARE(box.max.x(), 1.0);
    QCOMPARE(box.max.y() - box.min.y(), 1.0);
}

void AmbiguityMapTest::agreementIsNone()
{
    const AmbiguityMap map = mapOf({sheet().divided(0.5), sheet().divided(0.5), sheet().divided(0.5)});
    for (double value : map.either)
        QVERIFY(value < 1e-12);
    QCOMPARE(map.either.size(), sheet().mesh.vertices.size());
}

void AmbiguityMapTest::borderInHalfOfTheSamplesIsFull()
{
    const AmbiguityMap map = mapOf({sheet().divided(0.31), sheet().divided(0.71)});
    QVERIFY(sheet().range(map.border, 0.3, 0.32).first > 0.99);
    QVERIFY(sheet().range(map.border, 0.7, 0.72).first > 0.99);
    QVERIFY(sheet().range(map.border, 0.4, 0.6).second < 1e-12);
    QVERIFY(sheet().range(map.border, 0.8, 1.0).second < 1e-12);
    QCOMPARE(map.either, map.border); // the surface is the same
}

void AmbiguityMapTest::weightsCount()
{
    const AmbiguityMap map = mapOf({sheet().divided(0.31, 0, 0, 0.9), sheet().divided(0.71, 0, 0, 0.1)});
    const double expected = 4.0 * 0.9 * 0.1;
    QVERIFY(std::abs(sheet().range(map.border, 0.3, 0.32).first - expected) < 1e-9);
    QVERIFY(std::abs(sheet().range(map.border, 0.7, 0.72).first - expected) < 1e-9);
}

void AmbiguityMapTest::smallShiftsAreNoDisagreement()
{
    // By less than an edge: on the line itself both have a border nearby.
    const AmbiguityMap map = mapOf({sheet().divided(0.49), sheet().divided(0.51)});
    QVERIFY(sheet().range(map.border, 0.498, 0.502).second < 1e-12);
}

void AmbiguityMapTest::surfacesApartAreSeen()
{
    const AmbiguityMap map = mapOf({sheet().divided(0.5, 0.0, 0.012), sheet().divided(0.5, 0.0, 0.0)});
    QVERIFY(sheet().range(map.surface, 0.0, 0.45).second < 1e-12);
    QVERIFY(sheet().range(map.surface, 0.55, 1.0).first > 0.5);
    QVERIFY(sheet().range(map.border, 0.0, 1.0).second < 1e-12);
    QCOMPARE(map.either, map.surface);
}

void AmbiguityMapTest::surfaceSpreadIsMeasured()
{
    // Standard deviation of 0 and 0.012: 0.006, of a scale of 0.01.
    const AmbiguityMap map = mapOf({sheet().divided(0.5, 0.0, 0.012), sheet().divided(0.5, 0.0, 0.0)});
    QVERIFY(std::abs(sheet().range(map.surface, 0.55, 1.0).first - 0.6) < 1e-9);
}

void AmbiguityMapTest::wildModelsAreBounded()
{
    std::vector<LabelSample> samples(20, sheet().divided(0.5));
    samples.push_back(sheet().divided(0.5, 1e6, 0.0, 1e-3));
    QVERIFY(sheet().range(mapOf(samples).surface, 0.0, 0.45).second < 0.1);
}

void AmbiguityMapTest::nearBorderWalksThatFar()
{
    const std::vector<char> flags =
        nearBorder(sheet().mesh, sheet().topology, sheet().divided(0.51).segmentation.labels, 0.1);
    for (std::size_t v = 0; v < flags.size(); ++v) {
        const double distance = std::abs(sheet().mesh.vertices[v].x() - 0.51);
        QVERIFY(!flags[v] || distance < 0.1 + 1.0 / cells);
        QVERIFY(flags[v] || distance > 0.1 - 1.0 / cells);
    }
}

void AmbiguityMapTest::borderDifferenceIsALength()
{
    const auto difference = [](double a, double b) {
        return borderDifference(sheet().mesh, sheet().topology, sheet().divided(a).segmentation.labels,
                                sheet().divided(b).segmentation.labels, 0.03);
    };
    QCOMPARE(difference(0.31, 0.31), 0.0);
    QCOMPARE(difference(0.31, 0.33), 0.0); // within the tolerance
    // Two lines from side to side, each 1 long.
    QVERIFY2(std::abs(difference(0.31, 0.71) - 2.0) < 0.6,
             qPrintable(QString::number(difference(0.31, 0.71))));
    QCOMPARE(difference(0.31, 0.71), difference(0.71, 0.31));
    QVERIFY2(std::abs(difference(0.31, 2.0) - 1.0) < 0.3, qPrintable(QString::number(difference(0.31, 2.0))));
}

void AmbiguityMapTest::alternativesAreDifferentAndGood()
{
    const LabelSample reference = sheet().divided(0.5);
    LabelSample same = sheet().divided(0.51), bad = sheet().divided(0.2), good = sheet().divided(0.8);
    bad.segmentation.energy = 1.5;
    good.segmentation.energy = 1.1;
    const std::vector<int> chosen =
        alternatives(sheet().mesh, sheet().topology, reference.segmentation, {same, bad, good}, {});
    QCOMPARE(chosen, std::vector<int>{2});
}

void AmbiguityMapTest::alternativesDifferFromOneAnother()
{
    const LabelSample reference = sheet().divided(2.0); // one region
    const std::vector<LabelSample> samples{sheet().divided(0.3), sheet().divided(0.3), sheet().divided(0.5),
                                           sheet().divided(0.7), sheet().divided(0.9)};
    AlternativeOptions options;
    options.count = 3;
    const std::vector<int> chosen =
        alternatives(sheet().mesh, sheet().topology, reference.segmentation, samples, options);
    QCOMPARE(chosen.size(), std::size_t(3));
    QVERIFY(!(std::count(chosen.begin(), chosen.end(), 0) && std::count(chosen.begin(), chosen.end(), 1)));
}

QTEST_GUILESS_MAIN(AmbiguityMapTest)
#include "ambiguity_map_test.moc"
