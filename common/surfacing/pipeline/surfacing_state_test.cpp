#include "surfacing/pipeline/surfacing_state.h"

#include "support/box_sketch.h"
#include "surfacing/pipeline/restart.h"
#include "surfacing/pipeline/surface_pipeline.h"

#include <QtTest>

using namespace ductus;

namespace {

const Vec3 halfBox = BoxSketchOptions().halfBox;

SurfacingRequest smallRequest()
{
    SurfacingRequest request;
    request.strokes = boxSketch();
    request.options.proxy.targetVertices = 1500;
    request.options.proxy.fitPoints = 300;
    request.options.proxy.lambdaChoice.points = 120;
    request.options.proxy.cellsAlongDiagonal = 48;
    request.options.proxy.wrap.alphas = {1.0 / 4, 1.0 / 5, 1.0 / 6};
    request.options.segmentation.runs = 2;
    return request;
}

SurfacingState solved(const SurfacingState &before, const SurfacingRequest &request, int *previews = nullptr)
{
    const auto onPreview = [&](const SurfacingState &state) {
        if (previews)
            ++*previews;
        QVERIFY(state.hasLabels() && !state.hasSurface());
    };
    Result<SurfacingState> state = resurface(before, request, before.isPrepared(), onPreview, {});
    if (!state)
        qFatal("%s", state.error().message().c_str());
    return std::move(*state);
}

const SurfacingState &boxState()
{
    static const SurfacingState state = solved({}, smallRequest());
    return state;
}

Scribble splitOfTheTop()
{
    const double y = halfBox.y(), z = 1.1 * halfBox.z();
    return {ScribbleKind::Split, {Vec3(0.02, y, -z), Vec3(0.02, y, 0), Vec3(0.02, y, z)}, 0};
}

} // namespace

class SurfacingStateTest : public QObject
{
    Q_OBJECT
private slots:
    void stagesInARowAreThePipeline();
    void everyOptionRestartsAtItsStage();
    void scribbleKeepsSketchAndProxy();
    void oldStateStaysForUndo();
    void extractionOptionKeepsLabels();
    void nothingChangedNothingRun();
    void previewShowsTheRegionsOfTheSurface();
    void regionsKeepTheirNames();
    void cancelledScribbleLeavesTheStateAlone();
};

void SurfacingStateTest::stagesInARowAreThePipeline()
{
    const SurfacingRequest request = smallRequest();
    const Result<SurfaceResult> whole = surfaceSketch(request.strokes, std::nullopt, request.options, {});
    QVERIFY(whole.ok());
    QCOMPARE(whole->mesh.vertices, boxState().surface->mesh.vertices);
    QCOMPARE(whole->mesh.triangles, boxState().surface->mesh.triangles);
    QCOMPARE(whole->triangleRegions, boxState().surface->triangleRegions);
}

void SurfacingStateTest::everyOptionRestartsAtItsStage()
{
    const SurfaceOptions plain;
    const auto stageOf = [&](auto change) {
        SurfaceOptions changed;
        change(changed);
        return restartFrom(plain, changed);
    };
    QCOMPARE(stageOf([](SurfaceOptions &) {}), SurfacingStage::Nothing);
    QCOMPARE(stageOf([](SurfaceOptions &o) { o.symmetry = SymmetryMode::Auto; }), SurfacingStage::Sketch);
    QCOMPARE(stageOf([](SurfaceOptions &o) { o.symmetryPlane.offset = 1.0; }), SurfacingStage::Sketch);
    QCOMPARE(stageOf([](SurfaceOptions &o) { o.proxy.targetVertices = 3; }), SurfacingStage::Proxy);
    QCOMPARE(stageOf([](SurfaceOptions &o) { o.proxy.wrap.tightness = 0.5; }), SurfacingStage::Proxy);
    QCOMPARE(stageOf([](SurfaceOptions &o) { o.association.maxDistance = 0.5; }),
             SurfacingStage::Association);
    QCOMPARE(stageOf([](SurfaceOptions &o) { o.trim.clearanceRings = 9; }), SurfacingStage::Association);
    QCOMPARE(stageOf([](SurfaceOptions &o) { o.segmentation.epsilon = 0.5; }), SurfacingStage::Segmentation);
    QCOMPARE(stageOf([](SurfaceOptions &o) { o.segmentation.fit.boost = 3; }), SurfacingStage::Segmentation);
    QCOMPARE(stageOf([](SurfaceOptions &o) { o.segmentation.clusterCounts = {3}; }),
             SurfacingStage::Segmentation);
    QCOMPARE(stageOf([](SurfaceOptions &o) { o.extraction.damping = 1; }), SurfacingStage::Extraction);
}

void SurfacingStateTest::scribbleKeepsSketchAndProxy()
{
    SurfacingRequest request = smallRequest();
    request.scribbles = {splitOfTheTop()};
    int previews = 0;
    const SurfacingState after = solved(boxState(), request, &previews);
    QCOMPARE(previews, 1);
    QVERIFY(after.sketch == boxState().sketch);
    QVERIFY(after.proxy == boxState().proxy);
    QVERIFY(after.association == boxState().association);
    QCOMPARE(after.surface->regions.size(), boxState().surface->regions.size() + 1);
}

void SurfacingStateTest::oldStateStaysForUndo()
{
    const SurfacingState before = boxState();
    const std::vector<Vec3> vertices = before.surface->mesh.vertices;
    SurfacingRequest request = smallRequest();
    request.scribbles = {splitOfTheTop()};
    const SurfacingState after = solved(before, request);
    QVERIFY(after.surface->mesh.vertices != vertices);
    QCOMPARE(before.surface->mesh.vertices, vertices);
    // The scribble taken away again: the labels are the very ones of before.
    request.scribbles.clear();
    const SurfacingState back = solved(after, request);
    QVERIFY(back.labels == before.labels);
    QCOMPARE(back.surface->mesh.vertices, vertices);
}

void SurfacingStateTest::extractionOptionKeepsLabels()
{
    SurfacingRequest request = smallRequest();
    request.options.extraction.surfaceSmoothness = 10.0;
    int previews = 0;
    const SurfacingState after = solved(boxState(), request, &previews);
    QCOMPARE(previews, 0);
    QVERIFY(after.labels == boxState().labels);
    QVERIFY(after.surface->mesh.vertices != boxState().surface->mesh.vertices);
}

void SurfacingStateTest::nothingChangedNothingRun()
{
    const SurfacingState after = solved(boxState(), smallRequest());
    QVERIFY(after.surface == boxState().surface);
}

void SurfacingStateTest::previewShowsTheRegionsOfTheSurface()
{
    const LabelPreview &preview = *boxState().preview;
    const SurfaceResult &surface = *boxState().surface;
    QCOMPARE(preview.triangleRegions, surface.triangleRegions);
    QCOMPARE(preview.mesh.triangles, surface.mesh.triangles);
    QCOMPARE(preview.regions.size(), surface.regions.size());
    QCOMPARE(preview.regionIds.size(), surface.regions.size());
    QVERIFY(std::abs(surfaceArea(preview.mesh) / surfaceArea(surface.mesh) - 1.0) < 0.1);
}

void SurfacingStateTest::regionsKeepTheirNames()
{
    SurfacingRequest request = smallRequest();
    request.scribbles = {splitOfTheTop()};
    const SurfacingState after = solved(boxState(), request);
    const std::vector<int> &before = boxState().preview->regionIds, &now = after.preview->regionIds;
    int kept = 0;
    for (int id : before)
        kept += std::count(now.begin(), now.end(), id) == 1;
    QCOMPARE(kept, int(before.size()) - 1); // all but the one that was split
}

void SurfacingStateTest::cancelledScribbleLeavesTheStateAlone()
{
    const std::atomic<bool> cancelled = true;
    const Result<SurfacingState> result =
        solveLabels(boxState(), {splitOfTheTop()}, boxState().options, JobControl(&cancelled, {}));
    QVERIFY(!result.ok());
    QVERIFY(result.error().isCancelled());
}

QTEST_GUILESS_MAIN(SurfacingStateTest)
#include "surfacing_state_test.moc"
