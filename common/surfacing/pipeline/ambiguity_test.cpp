#include "surfacing/pipeline/ambiguity.h"

#include "support/sketch_synthesis.h"
#include "surfacing/pipeline/restart.h"

#include <QtTest>

using namespace ductus;

namespace {

struct Surfaced
{
    SurfacingState state;
    std::vector<Vec3> ridge; // input coordinates
};

// A house; without its ridge nobody knows whether the roof is bent or folded.
Surfaced surfacedHouse(bool withRidge, bool symmetric = false)
{
    const Solid solid = house();
    SketchSynthesisOptions synthesis;
    synthesis.seed = 3;
    const SyntheticSketch sketch = synthesizeSketch(solid, synthesis);
    SurfacingRequest request;
    request.options.proxy.targetVertices = 6000;
    request.options.segmentation.runs = 4;
    if (symmetric) {
        request.options.symmetry = SymmetryMode::Given;
        request.options.symmetryPlane = {Vec3::UnitZ(), 0.0};
    }
    Surfaced result;
    for (std::size_t i = 0; i < sketch.strokes.strokes.size(); ++i) {
        const FeatureCurve &curve = solid.curves[std::size_t(sketch.strokeCurves[i])];
        if (curve.name == "ridge")
            result.ridge = curve.points;
        if (curve.name != "ridge" || withRidge)
            request.strokes.strokes.push_back(sketch.strokes.strokes[i]);
    }
    Result<SurfacingState> state = resurface({}, request, false, {}, {});
    if (!state)
        qFatal("%s", state.error().message().c_str());
    result.state = std::move(*state);
    return result;
}

const Surfaced &ambiguousHouse()
{
    static const Surfaced surfaced = surfacedHouse(false);
    return surfaced;
}

Ambiguity ambiguityOf(const SurfacingState &state)
{
    AmbiguityOptions options;
    options.samples.runs = 5;
    Result<Ambiguity> result = findAmbiguity(state, options, {});
    if (!result)
        qFatal("%s", result.error().message().c_str());
    return std::move(*result);
}

const Ambiguity &ofAmbiguousHouse()
{
    static const Ambiguity ambiguity = ambiguityOf(ambiguousHouse().state);
    return ambiguity;
}

double distanceToRidge(const Surfaced &surfaced, const Vec3 &p)
{
    double nearest = 1e300;
    for (const Vec3 &q : surfaced.ridge)
        nearest = std::min(nearest, (p - q).norm());
    return nearest / surfaced.state.sketch->frame.diagonal;
}

// Mean of the shown map from one distance of the ridge to another.
double meanBetween(const Surfaced &surfaced, const Ambiguity &ambiguity, double from, double to)
{
    double sum = 0.0;
    int count = 0;
    const std::vector<Vec3> &vertices = surfaced.state.proxyInInput->vertices;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const double distance = distanceToRidge(surfaced, vertices[v]);
        if (distance >= from && distance < to) {
            sum += ambiguity.shown[v];
            ++count;
        }
    }
    return count ? sum / count : -1.0;
}

} // namespace

class AmbiguityTest : public QObject
{
    Q_OBJECT
private slots:
    void missingRidgeIsAmbiguousAndTheFloorIsNot();
    void drawnRidgeIsNotAmbiguous();
    void foldedRoofIsAnAlternative();
    void alternativeCanBeTaken();
    void symmetricMapCoversBothHalves();
    void sameQuestionSameAnswer();
    void cancelIsHeard();
};

void AmbiguityTest::missingRidgeIsAmbiguousAndTheFloorIsNot()
{
    QCOMPARE(ofAmbiguousHouse().shown.size(), ambiguousHouse().state.proxyInInput->vertices.size());
    for (double value : ofAmbiguousHouse().shown)
        QVERIFY(value >= 0.0 && value <= 1.0);
    const double near = meanBetween(ambiguousHouse(), ofAmbiguousHouse(), 0.0, 0.03);
    const double far = meanBetween(ambiguousHouse(), ofAmbiguousHouse(), 0.35, 2.0);
    QVERIFY2(near > 0.15 && far < 0.1 && near > 3.0 * far,
             qPrintable(QString("near %1 far %2").arg(near).arg(far)));
}

void AmbiguityTest::drawnRidgeIsNotAmbiguous()
{
    const Surfaced whole = surfacedHouse(true);
    const double near = meanBetween(whole, ambiguityOf(whole.state), 0.0, 0.03);
    const double without = meanBetween(ambiguousHouse(), ofAmbiguousHouse(), 0.0, 0.03);
    QVERIFY2(near < 0.5 * without, qPrintable(QString("%1 against %2").arg(near).arg(without)));
}

void AmbiguityTest::foldedRoofIsAnAlternative()
{
    const SurfacingState &state = ambiguousHouse().state;
    const Ambiguity &ambiguity = ofAmbiguousHouse();
    QVERIFY(!ambiguity.alternatives.empty());
    QVERIFY(ambiguity.alternatives.size() <= 3);
    const auto shareOfRidge = [&](const Segmentation &segmentation) {
        const std::vector<char> flags =
            nearBorder(state.proxy->proxy.mesh, state.proxy->topology, segmentation.labels, 0.03);
        int near = 0, count = 0;
        for (std::size_t v = 0; v < flags.size(); ++v)
            if (distanceToRidge(ambiguousHouse(), state.proxyInInput->vertices[v]) < 0.02) {
                ++count;
                near += flags[v];
            }
        return count ? double(near) / count : 0.0;
    };
    double most = 0.0;
    for (const Segmentation &alternative : ambiguity.alternatives) {
        most = std::max(most, shareOfRidge(alternative));
        QVERIFY(alternative.energy <= 1.3 * state.labels->segmentation.energy);
    }
    QVERIFY2(most > 0.8 && shareOfRidge(state.labels->segmentation) < 0.5,
             qPrintable(QString("%1 against %2").arg(most).arg(shareOfRidge(state.labels->segmentation))));
}

void AmbiguityTest::alternativeCanBeTaken()
{
    const SurfacingState &state = ambiguousHouse().state;
    const Segmentation &alternative = ofAmbiguousHouse().alternatives.front();
    const Result<SurfacingState> chosen = withAlternative(state, alternative, {});
    QVERIFY(chosen.ok());
    QCOMPARE(chosen->labels->segmentation.labels, alternative.labels);
    QVERIFY(!chosen->hasSurface());
    const Result<SurfacingState> surfaced = extractSurface(*chosen, chosen->options, {});
    QVERIFY(surfaced.ok());
    QVERIFY(surfaced->surface->mesh.vertices != state.surface->mesh.vertices);
    QVERIFY(surfaced->surface->deviation.median < 0.005);
}

void AmbiguityTest::symmetricMapCoversBothHalves()
{
    const Surfaced half = surfacedHouse(false, true);
    const Ambiguity ambiguity = ambiguityOf(half.state);
    const std::vector<Vec3> &vertices = half.state.proxyInInput->vertices;
    QCOMPARE(ambiguity.shown.size(), vertices.size());
    double front = 0.0, back = 0.0;
    for (std::size_t v = 0; v < vertices.size(); ++v)
        if (std::abs(vertices[v].z()) > 1e-6) // not in the plane itself
            (vertices[v].z() > 0.0 ? front : back) += ambiguity.shown[v];
    QVERIFY(front > 0.0 && std::abs(front - back) < 1e-6 * front);
}

void AmbiguityTest::sameQuestionSameAnswer()
{
    QCOMPARE(ambiguityOf(ambiguousHouse().state).shown, ofAmbiguousHouse().shown);
}

void AmbiguityTest::cancelIsHeard()
{
    const std::atomic<bool> cancelled = true;
    const Result<Ambiguity> result = findAmbiguity(ambiguousHouse().state, {}, JobControl(&cancelled, {}));
    QVERIFY(!result.ok());
    QVERIFY(result.error().isCancelled());
}

QTEST_GUILESS_MAIN(AmbiguityTest)
#include "ambiguity_test.moc"
