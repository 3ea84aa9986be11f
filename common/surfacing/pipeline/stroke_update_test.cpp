#include "surfacing/pipeline/stroke_update.h"

#include "strokes/resample.h"
#include "support/evaluation.h"
#include "surfacing/pipeline/restart.h"

#include <QtTest>

using namespace ductus;

namespace {

struct EditedSketch
{
    SurfacingRequest without, with; // the strokes of one curve
    GroundTruth truth;              // only that curve is a drawn crease
};

SurfacingRequest quickRequest()
{
    SurfacingRequest request;
    request.options.proxy.targetVertices = 3000;
    request.options.proxy.fitPoints = 300;
    request.options.proxy.lambdaChoice.points = 150;
    request.options.proxy.cellsAlongDiagonal = 56;
    request.options.segmentation.runs = 2;
    return request;
}

EditedSketch sketchWithAndWithout(const Solid &solid, const std::string &curve)
{
    SketchSynthesisOptions synthesis;
    synthesis.seed = 3;
    const SyntheticSketch whole = synthesizeSketch(solid, synthesis);
    EditedSketch sketch{quickRequest(), quickRequest(), whole.truth};
    sketch.with.strokes = whole.strokes;
    sketch.truth.drawnCreases.clear();
    for (std::size_t i = 0; i < whole.strokes.strokes.size(); ++i) {
        const FeatureCurve &drawn = solid.curves[std::size_t(whole.strokeCurves[i])];
        if (drawn.name == curve)
            sketch.truth.drawnCreases = {drawn.points};
        else
            sketch.without.strokes.strokes.push_back(whole.strokes.strokes[i]);
    }
    if (sketch.without.strokes.strokes.size() == whole.strokes.strokes.size())
        qFatal("there is no curve %s", curve.c_str());
    return sketch;
}

SurfacingState solved(const SurfacingState &before, const SurfacingRequest &request)
{
    Result<SurfacingState> state = resurface(before, request, false, {}, {});
    if (!state)
        qFatal("%s", state.error().message().c_str());
    return std::move(*state);
}

double recall(const SurfacingState &state, const GroundTruth &truth)
{
    const Result<CreaseScore> score = creaseScore(state.surface->mesh, truth);
    if (!score)
        qFatal("%s", score.error().message().c_str());
    return score->recall;
}

double distanceTo(const std::vector<std::vector<Vec3>> &curves, const Vec3 &p)
{
    double nearest = 1e300;
    for (const std::vector<Vec3> &curve : curves)
        for (const Vec3 &q : curve)
            nearest = std::min(nearest, (p - q).norm());
    return nearest;
}

const EditedSketch &houseSketch()
{
    static const EditedSketch sketch = sketchWithAndWithout(house(), "ridge");
    return sketch;
}

const SurfacingState &houseWithoutRidge()
{
    static const SurfacingState state = solved({}, houseSketch().without);
    return state;
}

const SurfacingState &houseWithRidge()
{
    static const SurfacingState state = solved(houseWithoutRidge(), houseSketch().with);
    return state;
}

bool saysSurfacedAnew(const SurfacingState &state)
{
    for (const std::string &warning : state.surface->warnings)
        if (warning.find("surfaced anew") != std::string::npos)
            return true;
    return false;
}

} // namespace

class StrokeUpdateTest : public QObject
{
    Q_OBJECT
private slots:
    void drawnFeatureStrokeBecomesACrease();
    void farAwayLittleChanges();
    void takenAwayStrokeTakesItsCreaseAlong();
    void renumberedStrokesChangeNothing();
    void movedStrokeMovesTheSurface();
    void scribblesStayAndCanBeTakenAway();
    void lockedRegionStays();
    void symmetricSketchIsUpdatedInItsHalf();
    void strokeOutOfReachIsAFullRun();
    void otherProxyIsAFullRun();
    void cancelledUpdateSaysSo();
    void markingTheFoundBorderSolvesNothing();
};

void StrokeUpdateTest::drawnFeatureStrokeBecomesACrease()
{
    QVERIFY2(recall(houseWithoutRidge(), houseSketch().truth) < 0.3,
             "the crease is there without its stroke");
    const double after = recall(houseWithRidge(), houseSketch().truth);
    QVERIFY2(after > 0.9, qPrintable(QString::number(after)));
    QCOMPARE(houseWithRidge().strokeUpdates, 1);
    QVERIFY(houseWithRidge().sketch->frame.diagonal == houseWithoutRidge().sketch->frame.diagonal);
    QCOMPARE(houseWithRidge().proxy->proxy.mesh.triangles, houseWithoutRidge().proxy->proxy.mesh.triangles);
    QVERIFY(!saysSurfacedAnew(houseWithRidge()));
    QCOMPARE(houseWithRidge().surface->strokeDeviation.size(), houseSketch().with.strokes.strokes.size());
}

void StrokeUpdateTest::farAwayLittleChanges()
{
    const double diagonal = houseWithRidge().sketch->frame.diagonal;
    const SurfaceResult &before = *houseWithoutRidge().surface, &after = *houseWithRidge().surface;
    const NearestOnMesh nearest(after.mesh);
    int count = 0;
    double sum = 0.0, most = 0.0;
    for (const Vec3 &p : before.mesh.vertices)
        if (distanceTo(houseSketch().truth.drawnCreases, p) > 0.4 * diagonal) {
            ++count;
            const double moved = nearest.nearest(p).distance / diagonal;
            sum += moved;
            most = std::max(most, moved);
        }
    QVERIFY(count > 500);
    QVERIFY2(sum / count < 0.001 && most < 0.015, qPrintable(QString("%1 %2").arg(sum / count).arg(most)));
    // Walls and floor keep their names; only the roof got another one.
    const std::vector<int> &ids = houseWithoutRidge().preview->regionIds,
                           &now = houseWithRidge().preview->regionIds;
    const auto kept = std::count_if(ids.begin(), ids.end(),
                                    [&](int id) { return std::count(now.begin(), now.end(), id) == 1; });
    QVERIFY2(kept >= 4, qPrintable(QString::number(kept)));
}

void StrokeUpdateTest::takenAwayStrokeTakesItsCreaseAlong()
{
    const SurfacingState back = solved(houseWithRidge(), houseSketch().without);
    QCOMPARE(back.strokeUpdates, 2);
    QVERIFY(back.proxy == houseWithRidge().proxy);
    QVERIFY(back.association->points.size() < houseWithRidge().association->points.size());
    const double after = recall(back, houseSketch().truth);
    QVERIFY2(after < 0.5, qPrintable(QString::number(after)));
}

void StrokeUpdateTest::renumberedStrokesChangeNothing()
{
    SurfacingRequest request = houseSketch().with;
    for (Stroke &stroke : request.strokes.strokes)
        stroke.id.value += 1000;
    const SurfacingState after = solved(houseWithRidge(), request);
    QCOMPARE(after.labels->segmentation.labels, houseWithRidge().labels->segmentation.labels);
    QCOMPARE(after.preview->regionIds, houseWithRidge().preview->regionIds);
    QCOMPARE(after.sketch->input.strokes.front().id.value, request.strokes.strokes.front().id.value);
}

void StrokeUpdateTest::movedStrokeMovesTheSurface()
{
    // The ridge and what meets it up by 4 %: the roof becomes steeper.
    SurfacingRequest request = houseSketch().with;
    const double top = request.strokes.box().max.y(), eaves = 0.24, rise = 0.025;
    double moved = 0.0;
    for (Stroke &stroke : request.strokes.strokes)
        for (Vec3 &p : stroke.points)
            if (p.y() > eaves) {
                p.y() += rise * (p.y() - eaves) / (top - eaves);
                moved = std::max(moved, p.y() - top);
            }
    QVERIFY(moved > 0.02);
    const SurfacingState after = solved(houseWithRidge(), request);
    for (const std::string &warning : after.surface->warnings)
        qInfo("%s", warning.c_str());
    QCOMPARE(after.strokeUpdates, 2);
    const Box3 before = boundingBox(houseWithRidge().surface->mesh.vertices),
               now = boundingBox(after.surface->mesh.vertices);
    QVERIFY2(std::abs(now.max.y() - before.max.y() - rise) < 0.3 * rise,
             qPrintable(QString::number(now.max.y() - before.max.y())));
    QVERIFY(std::abs(now.min.y() - before.min.y()) < 0.1 * rise);
    QVERIFY2(after.surface->deviation.median < 0.004,
             qPrintable(QString::number(after.surface->deviation.median)));
}

void StrokeUpdateTest::scribblesStayAndCanBeTakenAway()
{
    SurfacingRequest request = houseSketch().without;
    request.scribbles = {
        {ScribbleKind::Split, {Vec3(-0.3, 0, 0.03), Vec3(0, 0, 0.03), Vec3(0.3, 0, 0.03)}, 0}};
    const SurfacingState split = solved(houseWithoutRidge(), request);
    QCOMPARE(split.preview->regions.size(), houseWithoutRidge().preview->regions.size() + 1);
    request.strokes = houseSketch().with.strokes;
    const SurfacingState after = solved(split, request);
    QCOMPARE(after.labels->scribbles, request.scribbles);
    QCOMPARE(after.preview->regions.size(), houseWithRidge().preview->regions.size() + 1);
    QVERIFY(recall(after, houseSketch().truth) > 0.9);
    request.scribbles.clear();
    const SurfacingState plain = solved(after, request);
    QCOMPARE(plain.preview->regions.size(), houseWithRidge().preview->regions.size());
    QVERIFY(recall(plain, houseSketch().truth) > 0.9);
}

void StrokeUpdateTest::lockedRegionStays()
{
    SurfacingRequest request = houseSketch().without;
    const double roof = 0.22 + 0.17 / 2;
    request.scribbles = {{ScribbleKind::Lock, {Vec3(0.09, roof, 0.1)}, 0}};
    const SurfacingState locked = solved(houseWithoutRidge(), request);
    request.strokes = houseSketch().with.strokes;
    const SurfacingState after = solved(locked, request);
    QCOMPARE(after.labels->vertexIsLocked, locked.labels->vertexIsLocked);
    const auto idAt = [](const SurfacingState &state, std::size_t v) {
        return state.labels->modelIds[std::size_t(state.labels->segmentation.labels[v])];
    };
    int count = 0;
    for (std::size_t v = 0; v < after.labels->vertexIsLocked.size(); ++v)
        if (after.labels->vertexIsLocked[v]) {
            ++count;
            QCOMPARE(idAt(after, v), idAt(locked, v));
        }
    QVERIFY(count > 100);
}

void StrokeUpdateTest::symmetricSketchIsUpdatedInItsHalf()
{
    EditedSketch sketch = houseSketch();
    for (SurfacingRequest *request : {&sketch.with, &sketch.without}) {
        request->options.symmetry = SymmetryMode::Given;
        request->options.symmetryPlane = {Vec3::UnitZ(), 0.0};
    }
    const SurfacingState before = solved({}, sketch.without);
    const SurfacingState after = solved(before, sketch.with);
    QCOMPARE(after.strokeUpdates, 1);
    const SymmetryPlane &plane = *after.sketch->plane;
    QCOMPARE(plane.normal, before.sketch->plane->normal);
    for (const Vec3 &p : after.proxy->proxy.mesh.vertices)
        QVERIFY(plane.signedDistance(p) > -1e-9);
    QVERIFY2(recall(after, sketch.truth) > 0.9, qPrintable(QString::number(recall(after, sketch.truth))));
}

void StrokeUpdateTest::strokeOutOfReachIsAFullRun()
{
    SurfacingRequest request = houseSketch().without;
    Stroke inside; // across the house
    inside.points = resampled(std::vector<Vec3>{Vec3(-0.1, 0.15, -0.1), Vec3(0.1, 0.15, 0.1)}, 0.01);
    inside.id.value = 5000;
    request.strokes.strokes.push_back(inside);
    const SurfacingState after = solved(houseWithoutRidge(), request);
    QVERIFY(saysSurfacedAnew(after));
    QCOMPARE(after.strokeUpdates, 0);
    const SurfacingState fresh = solved({}, request);
    QCOMPARE(after.surface->mesh.vertices, fresh.surface->mesh.vertices);
    QVERIFY(!saysSurfacedAnew(fresh));
}

void StrokeUpdateTest::otherProxyIsAFullRun()
{
    SurfacingRequest request = houseSketch().with;
    request.givenProxy = *houseWithRidge().proxyInInput;
    const SurfacingState given = solved(houseWithRidge(), request);
    QCOMPARE(given.strokeUpdates, 0);
    QCOMPARE(given.roughProxy->kind, ProxyKind::Given);
    // The same proxy again: an update.
    request.strokes = houseSketch().without.strokes;
    QCOMPARE(solved(given, request).strokeUpdates, 1);
}

void StrokeUpdateTest::cancelledUpdateSaysSo()
{
    const std::atomic<bool> cancelled = true;
    const Result<SurfacingState> result =
        resurface(houseWithoutRidge(), houseSketch().with, false, {}, JobControl(&cancelled, {}));
    QVERIFY(!result.ok());
    QVERIFY(result.error().isCancelled());
}

void StrokeUpdateTest::markingTheFoundBorderSolvesNothing()
{
    SurfacingRequest request = quickRequest();
    request.strokes = synthesizeSketch(saddle(), {}).strokes;
    for (Stroke &stroke : request.strokes.strokes)
        stroke.role = StrokeRole::Surface;
    const SurfacingState before = solved({}, request);
    const StrokeSet &found = before.proxy->borderStrokes;
    QVERIFY(!found.strokes.empty());
    const auto mark = [&](std::size_t leftOut) {
        StrokeSet marked = request.strokes;
        for (Stroke &stroke : marked.strokes)
            for (std::size_t f = leftOut; f < found.strokes.size(); ++f)
                if (found.strokes[f].id == stroke.id)
                    stroke.role = StrokeRole::Boundary;
        return marked;
    };
    SurfacingRequest all = request;
    all.strokes = mark(0);
    const SurfacingState after = solved(before, all);
    QVERIFY(after.surface == before.surface);
    QVERIFY(!saysSurfacedAnew(after));
    QCOMPARE(after.sketch->input.strokes.size(), all.strokes.strokes.size());
    // Had it been solved with the marks from the start, it would be the same surface.
    QVERIFY(solved({}, all).surface->mesh.vertices == before.surface->mesh.vertices);

    SurfacingRequest some = request;
    some.strokes = mark(1);
    QVERIFY2(solved(before, some).surface != before.surface, "another border is another surface");
}

QTEST_GUILESS_MAIN(StrokeUpdateTest)
#include "stroke_update_test.moc"
