// First: moc 6.4 fails in <concepts> where <compare> (of base/typed_id.h) is the first standard header it
// meets.
#include "support/solids.h"

#include "support/sketch_synthesis.h"

#include "support/sample_sketches.h"
#include "support/segment_index.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace ductus;

namespace {

/// Nothing imprecise, nothing left out: the options each test starts from.
SketchSynthesisOptions perfectHand()
{
    return {.noise = 0.0,
            .jitter = 0.0,
            .overshoot = 0.0,
            .gapProbability = 0.0,
            .overdrawProbability = 0.0,
            .splitProbability = 0.0};
}

std::vector<Segment> segmentsOf(const std::vector<Vec3> &line)
{
    std::vector<Segment> segments;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        segments.push_back({line[i], line[i + 1]});
    return segments;
}

double distanceTo(const std::vector<Segment> &segments, const Vec3 &point)
{
    double nearest = 1e300;
    for (const Segment &segment : segments)
        nearest = std::min(nearest, distanceToSegment(point, segment));
    return nearest;
}

double totalLength(const std::vector<std::vector<Vec3>> &lines)
{
    double sum = 0.0;
    for (const auto &line : lines)
        sum += polylineLength(line);
    return sum;
}

double totalLength(const StrokeSet &set)
{
    double sum = 0.0;
    for (const Stroke &stroke : set.strokes)
        sum += polylineLength(stroke.points);
    return sum;
}

bool same(const Stroke &a, const Stroke &b)
{
    return a.points == b.points && a.role == b.role && a.pressure == b.pressure &&
           a.timeSeconds == b.timeSeconds;
}

} // namespace

class SketchSynthesisTest : public QObject
{
    Q_OBJECT
private slots:
    void sameSeedSameStrokesOtherSeedOthers();
    void perfectHandFollowsEveryCurve();
    void noiseHasTheSizeAskedFor();
    void strokesWobbleSlowly();
    void gapsAndMissingCurvesUncoverCreases();
    void overdrawingAddsStrokesBesideTheLine();
    void longLinesAreSplit();
    void overshootMovesOnlyEnds();
    void mirroredStrokesAreExactPairs();
    void mirroredHalvesCoverTheSameCreases();
    void leavingOutDetailsKeepsTheOtherStrokes();
    void boundariesOfShellsAreMarked();
    void channelsAndSamplingAreAHands();
    void sketchesLookLikePeoples_data();
    void sketchesLookLikePeoples();
};

void SketchSynthesisTest::sameSeedSameStrokesOtherSeedOthers()
{
    const Solid solid = bottle();
    const SyntheticSketch a = synthesizeSketch(solid, {.seed = 4}), b = synthesizeSketch(solid, {.seed = 4});
    QCOMPARE(a.strokes.strokes.size(), b.strokes.strokes.size());
    for (std::size_t i = 0; i < a.strokes.strokes.size(); ++i) {
        QVERIFY(same(a.strokes.strokes[i], b.strokes.strokes[i]));
        QCOMPARE(a.strokes.strokes[i].id.value, int(i));
    }
    QVERIFY(curvesText(a.strokes) != curvesText(synthesizeSketch(solid, {.seed = 5}).strokes));
}

void SketchSynthesisTest::perfectHandFollowsEveryCurve()
{
    for (const SolidEntry &entry : allSolids()) {
        const Solid solid = entry.make();
        const SyntheticSketch sketch = synthesizeSketch(solid, perfectHand());
        QCOMPARE(sketch.strokes.strokes.size(), solid.curves.size());
        for (std::size_t i = 0; i < solid.curves.size(); ++i) {
            QCOMPARE(sketch.strokeCurves[i], int(i));
            const std::vector<Segment> curve = segmentsOf(solid.curves[i].points);
            const Stroke &stroke = sketch.strokes.strokes[i];
            for (const Vec3 &point : stroke.points)
                QVERIFY(distanceTo(curve, point) < 1e-9);
            if (solid.curves[i].isClosed())
                QVERIFY((stroke.points.front() - stroke.points.back()).norm() < 1e-9);
            else
                QVERIFY((stroke.points.front() - solid.curves[i].points.front()).norm() < 1e-12);
        }
        QVERIFY(std::abs(totalLength(sketch.truth.creases) - totalLength(sketch.truth.drawnCreases)) < 1e-9);
        QCOMPARE(sketch.truth.faceCount, solid.faceCount());
    }
}

void SketchSynthesisTest::noiseHasTheSizeAskedFor()
{
    // Displacement along a curve moves no point off it: of three directions two count.
    const Solid solid = ellipsoid();
    SketchSynthesisOptions options = perfectHand();
    double square = 0.0;
    int count = 0;
    options.noise = 0.01;
    for (options.seed = 1; options.seed <= 40; ++options.seed) {
        const SyntheticSketch sketch = synthesizeSketch(solid, options);
        for (std::size_t i = 0; i < sketch.strokes.strokes.size(); ++i) {
            const auto curve = segmentsOf(solid.curves[std::size_t(sketch.strokeCurves[i])].points);
            for (const Vec3 &point : sketch.strokes.strokes[i].points) {
                square += std::pow(distanceTo(curve, point), 2);
                ++count;
            }
        }
    }
    const double expected = 0.01 * solid.diagonal() * std::sqrt(2.0 / 3.0);
    const double measured = std::sqrt(square / count);
    QVERIFY2(std::abs(measured - expected) < 0.12 * expected,
             (std::to_string(measured) + " against " + std::to_string(expected)).c_str());
}

void SketchSynthesisTest::strokesWobbleSlowly()
{
    // Displacements of neighbouring points hardly differ without jitter, and do with it.
    const Solid solid = house();
    const auto roughness = [&](double jitter) {
        SketchSynthesisOptions options = perfectHand();
        options.noise = 0.01;
        options.jitter = jitter;
        double bend = 0.0;
        for (const Stroke &stroke : synthesizeSketch(solid, options).strokes.strokes)
            for (std::size_t i = 1; i + 1 < stroke.points.size(); ++i)
                bend += (0.5 * (stroke.points[i - 1] + stroke.points[i + 1]) - stroke.points[i]).norm();
        return bend;
    };
    QVERIFY(roughness(0.005) > 1.5 * roughness(0.0));
}

void SketchSynthesisTest::gapsAndMissingCurvesUncoverCreases()
{
    const Solid solid = bevelledBox();
    SketchSynthesisOptions options = perfectHand();
    options.gapProbability = 1.0;
    const SyntheticSketch gaps = synthesizeSketch(solid, options);
    QVERIFY(gaps.strokes.strokes.size() > solid.curves.size());
    const double all = totalLength(gaps.truth.creases), drawn = totalLength(gaps.truth.drawnCreases);
    // One gap of about 3 % of the diagonal in each of 20 edges, rounded up to the points of the curve.
    QVERIFY(drawn < all - 10 * 0.03 * solid.diagonal());
    QVERIFY(drawn > all - 20 * 0.1 * solid.diagonal());

    options = perfectHand();
    options.missingShare = 0.5;
    int missing = 0;
    double covered = 0.0;
    for (options.seed = 1; options.seed <= 30; ++options.seed) {
        const SyntheticSketch sketch = synthesizeSketch(solid, options);
        missing += int(solid.curves.size() - sketch.strokes.strokes.size());
        covered += totalLength(sketch.truth.drawnCreases) / all / 30.0;
    }
    const double share = missing / (30.0 * double(solid.curves.size()));
    QVERIFY(share > 0.4 && share < 0.6);
    QVERIFY(covered > 0.4 && covered < 0.6);
}

void SketchSynthesisTest::overdrawingAddsStrokesBesideTheLine()
{
    const Solid solid = lBracket();
    SketchSynthesisOptions options = perfectHand();
    options.overdrawProbability = 1.0;
    const SyntheticSketch sketch = synthesizeSketch(solid, options);
    std::map<int, int> strokesOfCurve;
    double farthest = 0.0;
    for (std::size_t i = 0; i < sketch.strokes.strokes.size(); ++i) {
        const int c = sketch.strokeCurves[i];
        ++strokesOfCurve[c];
        for (const Vec3 &point : sketch.strokes.strokes[i].points)
            farthest = std::max(farthest, distanceTo(segmentsOf(solid.curves[std::size_t(c)].points), point));
    }
    std::set<int> counts;
    for (const auto &[curve, count] : strokesOfCurve)
        counts.insert(count);
    QCOMPARE(counts, (std::set<int>{2, 3}));
    QVERIFY(farthest > 0.7 * options.overdrawOffset * solid.diagonal());
    QVERIFY(farthest < 1.01 * options.overdrawOffset * solid.diagonal());
}

void SketchSynthesisTest::longLinesAreSplit()
{
    const Solid solid = torus();
    SketchSynthesisOptions options = perfectHand();
    options.splitProbability = 1.0;
    options.splitLength = 0.2;
    const SyntheticSketch sketch = synthesizeSketch(solid, options);
    QCOMPARE(sketch.strokes.strokes.size(), 4 * solid.curves.size());
    // Split, not shortened (chords of the sampling are a little shorter than the curves).
    double length = 0.0;
    for (const FeatureCurve &curve : solid.curves)
        length += polylineLength(curve.points);
    QVERIFY(std::abs(totalLength(sketch.strokes) - length) < 0.01 * length);
}

void SketchSynthesisTest::overshootMovesOnlyEnds()
{
    const Solid solid = house();
    SketchSynthesisOptions options = perfectHand();
    options.overshoot = 0.02;
    int beyond = 0, before = 0;
    const SyntheticSketch sketch = synthesizeSketch(solid, options);
    for (std::size_t i = 0; i < sketch.strokes.strokes.size(); ++i) {
        const FeatureCurve &curve = solid.curves[std::size_t(sketch.strokeCurves[i])];
        if (curve.isClosed())
            continue;
        const Vec3 end = sketch.strokes.strokes[i].points.back();
        const double miss = (end - curve.points.back()).norm();
        QVERIFY(miss <= 0.02 * solid.diagonal() + 1e-12);
        (distanceTo(segmentsOf(curve.points), end) > 1e-9 ? beyond : before) += 1;
    }
    QVERIFY(beyond > 3 && before > 3);
}

void SketchSynthesisTest::mirroredStrokesAreExactPairs()
{
    const Solid solid = car();
    const SyntheticSketch sketch = synthesizeSketch(solid, {.seed = 7, .mirrorStrokes = true});
    int inPlane = 0, pairs = 0;
    const auto &strokes = sketch.strokes.strokes;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const auto isFlat =
            std::all_of(strokes[i].points.begin(), strokes[i].points.end(),
                        [&](const Vec3 &p) { return std::abs(solid.mirror->signedDistance(p)) < 1e-9; });
        if (isFlat) {
            ++inPlane;
            continue;
        }
        QVERIFY(i + 1 < strokes.size());
        QCOMPARE(strokes[i].points.size(), strokes[i + 1].points.size());
        for (std::size_t k = 0; k < strokes[i].points.size(); ++k)
            QVERIFY(solid.mirror->mirrored(strokes[i].points[k]) == strokes[i + 1].points[k]);
        ++i;
        ++pairs;
    }
    QVERIFY(inPlane >= 7 && pairs > 20);
}

void SketchSynthesisTest::mirroredHalvesCoverTheSameCreases()
{
    for (const Solid &solid : {car(), bottle(), iron(), lBracket()}) {
        SketchSynthesisOptions options = perfectHand();
        options.mirrorStrokes = true;
        const SyntheticSketch sketch = synthesizeSketch(solid, options);
        const double all = totalLength(sketch.truth.creases), drawn = totalLength(sketch.truth.drawnCreases);
        QVERIFY2(std::abs(all - drawn) < 1e-6 * all, solid.id.c_str());
    }
}

void SketchSynthesisTest::leavingOutDetailsKeepsTheOtherStrokes()
{
    const Solid solid = car();
    const SyntheticSketch with = synthesizeSketch(solid, {.seed = 3}),
                          without = synthesizeSketch(solid, {.seed = 3, .detailShare = 0.0});
    QVERIFY(without.strokes.strokes.size() < with.strokes.strokes.size());
    std::size_t k = 0;
    for (std::size_t i = 0; i < with.strokes.strokes.size(); ++i) {
        if (solid.curves[std::size_t(with.strokeCurves[i])].kind == CurveKind::Detail)
            continue;
        QVERIFY(k < without.strokes.strokes.size());
        QVERIFY(same(with.strokes.strokes[i], without.strokes.strokes[k++]));
    }
    QCOMPARE(k, without.strokes.strokes.size());
}

void SketchSynthesisTest::boundariesOfShellsAreMarked()
{
    const Solid solid = saddle();
    const SyntheticSketch sketch = synthesizeSketch(solid, {.gapProbability = 0.5});
    for (std::size_t i = 0; i < sketch.strokes.strokes.size(); ++i)
        QCOMPARE(sketch.strokes.strokes[i].role == StrokeRole::Boundary,
                 solid.curves[std::size_t(sketch.strokeCurves[i])].kind == CurveKind::Boundary);
    QCOMPARE(sketch.truth.boundaries.size(), std::size_t(4));
    QVERIFY(sketch.truth.creases.empty());
}

void SketchSynthesisTest::channelsAndSamplingAreAHands()
{
    const auto spread = [](double unevenness) {
        SketchSynthesisOptions options = perfectHand();
        options.unevenness = unevenness;
        std::vector<double> steps;
        for (const Stroke &stroke : synthesizeSketch(house(), options).strokes.strokes)
            for (std::size_t i = 0; i + 2 < stroke.points.size(); ++i)
                steps.push_back((stroke.points[i + 1] - stroke.points[i]).norm());
        double mean = 0.0;
        for (const double step : steps)
            mean += step / double(steps.size());
        double square = 0.0;
        for (const double step : steps)
            square += (step - mean) * (step - mean) / double(steps.size());
        return std::sqrt(square) / mean;
    };
    QVERIFY(spread(1.0) > spread(0.0) + 0.15);
    for (const Stroke &stroke : synthesizeSketch(car(), {}).strokes.strokes) {
        QCOMPARE(stroke.pressure.size(), stroke.points.size());
        QCOMPARE(stroke.timeSeconds.size(), stroke.points.size());
        QVERIFY(std::is_sorted(stroke.timeSeconds.begin(), stroke.timeSeconds.end()));
        for (const double pressure : stroke.pressure)
            QVERIFY(pressure > 0.0 && pressure <= 1.0);
    }
}

void SketchSynthesisTest::sketchesLookLikePeoples_data()
{
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < sampleSketches().size(); ++i)
        QTest::newRow(sampleSketches()[i].id.c_str()) << int(i);
}

void SketchSynthesisTest::sketchesLookLikePeoples()
{
    QFETCH(int, index);
    const SampleSketch &sample = sampleSketches()[std::size_t(index)];
    const Solid solid = sample.makeSolid();
    const StrokeSet strokes = synthesizeSketch(solid, sample.options).strokes;
    // Ranges of the 18 CASSIE drawings: 16-199 strokes, longest stroke 0.35-1.6 of the diagonal.
    QVERIFY(strokes.strokes.size() >= 13 && strokes.strokes.size() <= 303);
    double longest = 0.0;
    for (const Stroke &stroke : strokes.strokes) {
        QVERIFY(stroke.points.size() >= 5);
        for (const Vec3 &point : stroke.points)
            QVERIFY(point.allFinite());
        longest = std::max(longest, polylineLength(stroke.points) / solid.diagonal());
    }
    QVERIFY(longest > 0.3 && longest < 2.0);
}

QTEST_APPLESS_MAIN(SketchSynthesisTest)
#include "sketch_synthesis_test.moc"
