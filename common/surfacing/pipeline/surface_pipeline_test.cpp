#include "surfacing/pipeline/surface_pipeline.h"

#include "base/random.h"
#include "geometry/nearest.h"
#include "support/box_sketch.h"
#include "support/mesh_zoo.h"

#include <QtTest>

using namespace ductus;

namespace {

const Vec3 halfBox(0.5, 0.32, 0.4); // input units; a box with creases and cross-sections

// The box moved by \a shift and scaled.
StrokeSet sketchedBox(const Vec3 &shift = Vec3::Zero(), double scale = 1.0)
{
    StrokeSet set = boxSketch({halfBox});
    for (Stroke &stroke : set.strokes)
        for (Vec3 &p : stroke.points)
            p = scale * p + shift;
    return set;
}

SurfaceOptions smallOptions()
{
    SurfaceOptions options;
    options.proxy.targetVertices = 1500;
    options.proxy.fitPoints = 300;
    options.proxy.lambdaChoice.points = 120;
    options.proxy.cellsAlongDiagonal = 48;
    options.proxy.wrap.alphas = {1.0 / 4, 1.0 / 5, 1.0 / 6};
    options.segmentation.runs = 3;
    return options;
}

SurfaceResult surfaced(const StrokeSet &sketch, const SurfaceOptions &options)
{
    Result<SurfaceResult> result = surfaceSketch(sketch, std::nullopt, options, {});
    if (!result)
        qFatal("%s", result.error().message().c_str());
    return std::move(*result);
}

const SurfaceResult &boxSurface()
{
    static const SurfaceResult result = surfaced(sketchedBox(), smallOptions());
    return result;
}

// Distance to the surface of the box.
double offBox(const Vec3 &p)
{
    const Vec3 d = p.cwiseAbs() - halfBox;
    return d.maxCoeff() <= 0.0 ? -d.maxCoeff() : d.cwiseMax(0.0).norm();
}

const double boxDiagonal = 2.0 * halfBox.norm();

} // namespace

class SurfacePipelineTest : public QObject
{
    Q_OBJECT
private slots:
    void boxBecomesAClosedManifold();
    void surfaceLiesOnTheBox();
    void regionsAreTheFaces();
    void creasesAreTheEdges();
    void deviationIsWhatItSays();
    void movesAndScalesWithTheSketch();
    void mirroredHalfIsExactlySymmetric();
    void symmetryIsFoundOrItsLackTold();
    void ignoredStrokesAreLeftOut();
    void skeletalStrokesBecomeTubes();
    void givenProxyIsUsed();
    void sameSketchSameBytes();
    void tooLittleDataIsRefused();
    void cancelledAtRandomProgress();
};

void SurfacePipelineTest::boxBecomesAClosedManifold()
{
    const SurfaceResult &r = boxSurface();
    const ManifoldReport report = manifoldReport(r.mesh);
    QVERIFY(report.isClosed());
    QCOMPARE(report.components, 1);
    QCOMPARE(r.mesh.vertexCount() - int(MeshTopology(r.mesh).edges.size()) + r.mesh.triangleCount(), 2);
    const double volume = 8.0 * halfBox.prod();
    QVERIFY2(std::abs(signedVolume(r.mesh) / volume - 1.0) < 0.02,
             qPrintable(QString::number(signedVolume(r.mesh))));
    for (const Vec3 &p : r.mesh.vertices)
        QVERIFY(p.allFinite());
    QVERIFY(r.timings.total > 0.0);
    QVERIFY(r.timings.proxy + r.timings.association + r.timings.segmentation + r.timings.extraction <=
            r.timings.total * 1.01);
}

void SurfacePipelineTest::surfaceLiesOnTheBox()
{
    std::vector<double> distances;
    for (const Vec3 &p : boxSurface().mesh.vertices)
        distances.push_back(offBox(p) / boxDiagonal);
    std::sort(distances.begin(), distances.end());
    QVERIFY2(distances[distances.size() / 2] < 0.003,
             qPrintable(QString::number(distances[distances.size() / 2])));
    QVERIFY2(distances.back() < 0.02, qPrintable(QString::number(distances.back())));
}

void SurfacePipelineTest::regionsAreTheFaces()
{
    const SurfaceResult &r = boxSurface();
    QCOMPARE(r.triangleRegions.size(), r.mesh.triangles.size());
    QCOMPARE(r.regions.size(), std::size_t(6));
    std::vector<double> areas(r.regions.size(), 0.0);
    std::vector<Vec3> normals(r.regions.size(), Vec3::Zero());
    for (int t = 0; t < r.mesh.triangleCount(); ++t) {
        QVERIFY(r.triangleRegions[t] >= 0 && r.triangleRegions[t] < int(r.regions.size()));
        areas[r.triangleRegions[t]] += 0.5 * r.mesh.areaVector(t).norm();
        normals[r.triangleRegions[t]] += 0.5 * r.mesh.areaVector(t);
    }
    for (std::size_t i = 0; i < areas.size(); ++i) {
        QVERIFY(std::abs(r.regions[i].area - areas[i]) < 1e-9);
        QVERIFY(r.regions[i].degree >= 1 && r.regions[i].degree <= 4);
        int axis;
        QVERIFY(normals[i].normalized().cwiseAbs().maxCoeff(&axis) > 0.99);
        const double face = 4.0 * halfBox.prod() / halfBox[axis];
        QVERIFY(std::abs(areas[i] / face - 1.0) < 0.1);
    }
}

void SurfacePipelineTest::creasesAreTheEdges()
{
    const SurfaceResult &r = boxSurface();
    double length = 0.0;
    for (const std::vector<int> &feature : r.featureLines)
        for (std::size_t i = 0; i < feature.size(); ++i) {
            const Vec3 p = r.mesh.vertices[feature[i]];
            const Vec3 gap = (p.cwiseAbs() - halfBox).cwiseAbs();
            const double second = gap.sum() - gap.maxCoeff() - gap.minCoeff(); // near two faces at once
            QVERIFY2(second < 0.02 * boxDiagonal, qPrintable(QString::number(second / boxDiagonal)));
            if (i > 0)
                length += (p - r.mesh.vertices[feature[i - 1]]).norm();
        }
    const double edges = 8.0 * halfBox.sum();
    QVERIFY2(length > 0.85 * edges && length < 1.1 * edges, qPrintable(QString::number(length / edges)));
}

void SurfacePipelineTest::deviationIsWhatItSays()
{
    const SurfaceResult &r = boxSurface();
    QVERIFY(r.deviation.median >= 0.0 && r.deviation.median < 0.003);
    QVERIFY(r.deviation.median <= r.deviation.p95 && r.deviation.p95 <= r.deviation.max);
    QVERIFY(r.deviation.mean <= r.deviation.max && r.deviation.max < 0.03);
    const StrokeSet sketch = sketchedBox();
    QCOMPARE(r.strokeDeviation.size(), sketch.strokes.size());
    const NearestOnMesh nearest(r.mesh);
    const double diagonal = sketch.box().diagonal();
    for (std::size_t s = 0; s < sketch.strokes.size(); ++s) {
        double worst = 0.0;
        for (const Vec3 &p : sketch.strokes[s].points)
            worst = std::max(worst, nearest.nearest(p).distance / diagonal);
        QVERIFY(std::abs(r.strokeDeviation[s] - worst) < 2e-3); // sampled in other places
    }
}

void SurfacePipelineTest::movesAndScalesWithTheSketch()
{
    const Vec3 shift(40.0, -10.0, 25.0);
    const SurfaceResult moved = surfaced(sketchedBox(shift, 8.0), smallOptions());
    QVERIFY(manifoldReport(moved.mesh).isClosed());
    QCOMPARE(moved.regions.size(), boxSurface().regions.size());
    double worst = 0.0;
    for (const Vec3 &p : moved.mesh.vertices)
        worst = std::max(worst, offBox((p - shift) / 8.0) / boxDiagonal);
    QVERIFY(worst < 0.02);
    double area = 0.0;
    for (const SurfaceRegion &region : moved.regions)
        area += region.area;
    QVERIFY(std::abs(area / (64.0 * surfaceArea(boxSurface().mesh)) - 1.0) < 0.02);
}

void SurfacePipelineTest::mirroredHalfIsExactlySymmetric()
{
    SurfaceOptions options = smallOptions();
    options.symmetry = SymmetryMode::Given;
    const Vec3 shift(0.3, 0.0, 0.0);
    options.symmetryPlane = {Vec3::UnitX(), 0.3};
    const SurfaceResult r = surfaced(sketchedBox(shift), options);
    QVERIFY(manifoldReport(r.mesh).isClosed());
    QVERIFY(signedVolume(r.mesh) > 0.0);
    QCOMPARE(r.triangleRegions.size(), r.mesh.triangles.size());
    const NearestOnMesh nearest(r.mesh);
    for (const Vec3 &p : r.mesh.vertices)
        QVERIFY(nearest.nearest(options.symmetryPlane.mirrored(p)).distance < 1e-9);
    double worst = 0.0;
    for (const Vec3 &p : r.mesh.vertices)
        worst = std::max(worst, offBox(p - shift) / boxDiagonal);
    QVERIFY2(worst < 0.02, qPrintable(QString::number(worst)));
    QVERIFY(manifoldReport(r.proxy.mesh).isClosed());
}

void SurfacePipelineTest::symmetryIsFoundOrItsLackTold()
{
    SurfaceOptions options = smallOptions();
    options.symmetry = SymmetryMode::Auto;
    const SurfaceResult r = surfaced(sketchedBox(Vec3(0.0, 2.0, 0.0)), options);
    QVERIFY(r.symmetry.has_value());
    const Vec3 n = r.symmetry->plane.normal;
    QVERIFY(n.cwiseAbs().maxCoeff() > 0.999);
    QVERIFY(std::abs(r.symmetry->plane.signedDistance({0.0, 2.0, 0.0})) < 0.01); // in input coordinates
    QVERIFY(manifoldReport(r.mesh).isClosed());

    StrokeSet lopsided;
    for (const Stroke &stroke : sketchedBox().strokes) {
        lopsided.strokes.push_back(stroke);
        for (Vec3 &p : lopsided.strokes.back().points) {
            p *= 1.0 + 0.3 * p.x() + 0.25 * p.y() + 0.2 * p.z();
            p.x() += 0.3 * p.y();
        }
    }
    const SurfaceResult whole = surfaced(lopsided, options);
    QVERIFY(!whole.symmetry.has_value());
    QVERIFY(!whole.warnings.empty());
}

void SurfacePipelineTest::ignoredStrokesAreLeftOut()
{
    StrokeSet sketch = sketchedBox();
    const std::size_t drawn = sketch.strokes.size();
    for (StrokeRole role : {StrokeRole::Ignored, StrokeRole::Inner}) {
        Stroke stroke = straightStroke({-0.2, -0.1, 0.0}, {0.3, 0.2, 0.9}, 0.03);
        stroke.id.value = int(sketch.strokes.size());
        stroke.role = role;
        sketch.strokes.push_back(stroke);
    }
    const SurfaceResult r = surfaced(sketch, smallOptions());
    QVERIFY(r.mesh.vertices == boxSurface().mesh.vertices);
    QCOMPARE(r.strokeDeviation.size(), drawn + 2);
    for (std::size_t s = 0; s < r.strokeDeviation.size(); ++s)
        QCOMPARE(r.strokeDeviation[s] >= 0.0, s < drawn);
}

void SurfacePipelineTest::skeletalStrokesBecomeTubes()
{
    StrokeSet sketch = sketchedBox();
    Stroke cable = straightStroke({0.5, 0.0, 0.0}, {2.5, 0.4, 0.0}, 0.03); // far out of the box
    cable.id.value = int(sketch.strokes.size());
    cable.role = StrokeRole::Skeletal;
    sketch.strokes.push_back(cable);
    const SurfaceResult r = surfaced(sketch, smallOptions());
    const SurfaceResult &plain = boxSurface();
    // The surface is the same to the bit, the tube a closed shell after it.
    QVERIFY(std::equal(plain.mesh.vertices.begin(), plain.mesh.vertices.end(), r.mesh.vertices.begin()));
    QCOMPARE(r.regions.size(), plain.regions.size() + 1);
    QVERIFY(r.regions.back().tubeOf && *r.regions.back().tubeOf == cable.id);
    QVERIFY(r.regions.back().area > 0.0);
    QCOMPARE(r.triangleRegions.size(), r.mesh.triangles.size());
    const ManifoldReport report = manifoldReport(r.mesh);
    QVERIFY(report.isClosed());
    QCOMPARE(report.components, 2);
    QVERIFY(boundingBox(r.mesh.vertices).max.x() > 2.5);
    QCOMPARE(r.strokeDeviation.back(), -1.0);
}

void SurfacePipelineTest::givenProxyIsUsed()
{
    TriangleMesh rough = zoo::box(-1.04 * halfBox, 1.04 * halfBox);
    const auto r = surfaceSketch(sketchedBox(), rough, smallOptions(), {});
    QVERIFY(r.ok());
    QCOMPARE(r->proxy.kind, ProxyKind::Given);
    QVERIFY(manifoldReport(r->mesh).isClosed());
    QVERIFY(r->deviation.median < 0.003);
    for (Vec3 &p : rough.vertices) // another place altogether
        p += Vec3(50, 0, 0);
    const auto elsewhere = surfaceSketch(sketchedBox(), rough, smallOptions(), {});
    QVERIFY(!elsewhere.ok());
    QVERIFY(!elsewhere.error().problem.empty() && !elsewhere.error().remedy.empty());
}

void SurfacePipelineTest::sameSketchSameBytes()
{
    const SurfaceResult again = surfaced(sketchedBox(), smallOptions());
    QVERIFY(again.mesh.vertices == boxSurface().mesh.vertices);
    QVERIFY(again.mesh.triangles == boxSurface().mesh.triangles);
    QCOMPARE(again.triangleRegions, boxSurface().triangleRegions);
    QCOMPARE(again.featureLines, boxSurface().featureLines);
    QCOMPARE(again.strokeDeviation, boxSurface().strokeDeviation);
}

void SurfacePipelineTest::tooLittleDataIsRefused()
{
    StrokeSet dots, ignored = sketchedBox(), same;
    for (int i = 0; i < 5; ++i) {
        Stroke stroke;
        stroke.points = {{0.1 * i, 0, 0}};
        dots.strokes.push_back(stroke);
        stroke.points = {{1, 2, 3}, {1, 2, 3}};
        same.strokes.push_back(stroke);
    }
    for (Stroke &stroke : ignored.strokes)
        stroke.role = StrokeRole::Ignored;
    for (const StrokeSet &set : {StrokeSet(), dots, ignored, same}) {
        const auto r = surfaceSketch(set, std::nullopt, smallOptions(), {});
        QVERIFY(!r.ok());
        QCOMPARE(r.error().code, ErrorCode::TooLittleData);
        QVERIFY(!r.error().remedy.empty());
    }
}

void SurfacePipelineTest::cancelledAtRandomProgress()
{
    double last = 0.0;
    const JobControl watching(nullptr, [&](double fraction, std::string_view text) {
        QVERIFY(fraction >= 0.0 && fraction <= 1.0 && !text.empty());
        last = std::max(last, fraction);
    });
    QVERIFY(surfaceSketch(sketchedBox(), std::nullopt, smallOptions(), watching).ok());
    QVERIFY(last > 0.8);
    Random random(17);
    for (int trial = 0; trial < 8; ++trial) {
        const double at = trial == 0 ? 0.0 : random.uniform(0.0, 0.85);
        std::atomic<bool> cancel = false;
        const JobControl control(&cancel, [&](double fraction, std::string_view) {
            if (fraction >= at)
                cancel = true;
        });
        const auto r = surfaceSketch(sketchedBox(), std::nullopt, smallOptions(), control);
        QVERIFY2(!r.ok(), qPrintable(QString::number(at)));
        QVERIFY2(r.error().isCancelled(), r.error().message().c_str());
    }
}

QTEST_APPLESS_MAIN(SurfacePipelineTest)
#include "surface_pipeline_test.moc"
