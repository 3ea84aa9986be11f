#include "support/evaluation.h"

#include "base/random.h"
#include "support/segment_index.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace ductus;

namespace {

TriangleMesh moved(TriangleMesh mesh, const Vec3 &shift, double scale = 1.0)
{
    for (Vec3 &vertex : mesh.vertices)
        vertex = scale * vertex + shift;
    return mesh;
}

GroundTruth truthOf(const Solid &solid)
{
    return synthesizeSketch(solid, {}).truth;
}

} // namespace

class EvaluationTest : public QObject
{
    Q_OBJECT
private slots:
    void theTruthDeviatesNotAtAll();
    void aSwollenSphereDeviatesByItsSwelling();
    void missingSurfaceShowsInOneDirectionOnly();
    void samplesAreUniformInArea();
    void statisticsAreQuantiles();
    void strokesOnTheSurfaceHaveTheirNoise();
    void creasesOfTheTruthAreFound();
    void smoothResultsHaveNoCreases();
    void creasesAreLostBeyondTheTolerance();
    void regionsAreCountedAsConnected();
    void segmentIndexAgreesWithBruteForce();
    void brokenInputIsRefused();
};

void EvaluationTest::theTruthDeviatesNotAtAll()
{
    const Solid solid = bottle();
    const auto deviation = surfaceDeviation(solid.mesh, solid.mesh);
    QVERIFY(deviation.ok());
    QVERIFY(deviation->resultToTruth.max < 1e-9 && deviation->truthToResult.max < 1e-9);
}

void EvaluationTest::aSwollenSphereDeviatesByItsSwelling()
{
    // Radius 1 against 1.02: 0.02 of a diagonal of 2 sqrt(3), everywhere.
    const TriangleMesh sphere = ellipsoid(Vec3(1, 1, 1)).mesh;
    const auto deviation = surfaceDeviation(moved(sphere, Vec3::Zero(), 1.02), sphere, {.samples = 5000});
    QVERIFY(deviation.ok());
    const double expected = 100.0 * 0.02 / (2.0 * std::sqrt(3.0));
    for (const DeviationStatistics &s : {deviation->resultToTruth, deviation->truthToResult}) {
        QVERIFY(std::abs(s.median - expected) < 0.02 * expected);
        QVERIFY(std::abs(s.mean - expected) < 0.02 * expected);
        QVERIFY(s.max < 1.1 * expected);
    }
}

void EvaluationTest::missingSurfaceShowsInOneDirectionOnly()
{
    const Solid solid = bevelledBox();
    TriangleMesh lidless = solid.mesh;
    lidless.triangles.clear();
    for (int t = 0; t < solid.mesh.triangleCount(); ++t)
        if (solid.faceNames[std::size_t(solid.triangleFaces[std::size_t(t)])] != "top")
            lidless.triangles.push_back(solid.mesh.triangles[std::size_t(t)]);
    const auto deviation = surfaceDeviation(lidless, solid.mesh);
    QVERIFY(deviation.ok());
    QVERIFY(deviation->resultToTruth.max < 1e-9);
    // The middle of the lid (0.38 x 0.24) is 0.12 from its rim.
    QVERIFY(std::abs(deviation->truthToResult.max - 100.0 * 0.12 / solid.diagonal()) < 1.0);
    QVERIFY(deviation->truthToResult.median < 1e-9);
}

void EvaluationTest::samplesAreUniformInArea()
{
    TriangleMesh mesh;
    mesh.vertices = {Vec3(0, 0, 0),  Vec3(3, 0, 0), Vec3(0, 1, 0),
                     Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(0, 0, 0)};
    mesh.triangles = {{0, 1, 2}, {0, 3, 4}, {0, 5, 1}}; // areas 1.5, 0.5, 0
    const auto samples = sampledByArea(mesh, 4000, 1);
    int first = 0;
    Vec3 mean = Vec3::Zero();
    for (const SurfacePoint &sample : samples) {
        QVERIFY(sample.triangle == 0 || sample.triangle == 1);
        if (sample.triangle == 0) {
            ++first;
            mean += sample.point;
        }
    }
    QVERIFY(std::abs(first - 3000) <= 1);
    QVERIFY((mean / first - mesh.centroid(0)).norm() < 0.04);
}

void EvaluationTest::statisticsAreQuantiles()
{
    std::vector<double> distances;
    for (int i = 100; i >= 0; --i)
        distances.push_back(i);
    const DeviationStatistics s = deviationStatistics(distances, 100.0);
    QCOMPARE(s.median, 50.0);
    QCOMPARE(s.mean, 50.0);
    QCOMPARE(s.p95, 95.0);
    QCOMPARE(s.max, 100.0);
    QCOMPARE(deviationStatistics({}, 1.0).max, 0.0);
}

void EvaluationTest::strokesOnTheSurfaceHaveTheirNoise()
{
    const Solid solid = ellipsoid();
    SyntheticSketch sketch = synthesizeSketch(solid, {.noise = 0.01, .overdrawProbability = 0.0});
    const auto noisy = strokeDeviation(sketch.strokes, solid.mesh);
    QVERIFY(noisy.ok());
    QVERIFY(noisy->mean > 0.2 && noisy->mean < 1.0);
    // Strokes that are no part of the surface do not count.
    for (std::size_t i = 1; i < sketch.strokes.strokes.size(); ++i)
        sketch.strokes.strokes[i].role = StrokeRole::Ignored;
    sketch.strokes.strokes[0].points = {solid.mesh.vertices[0], solid.mesh.vertices[0]};
    QVERIFY(strokeDeviation(sketch.strokes, solid.mesh)->max < 1e-9);
}

void EvaluationTest::creasesOfTheTruthAreFound()
{
    for (const Solid &solid : {bevelledBox(), bottle(), car(), iron(), bentLeaf(), computerMouse()}) {
        const auto score = creaseScore(solid.mesh, truthOf(solid));
        QVERIFY(score.ok());
        QVERIFY2(score->recall > 0.9999, solid.id.c_str());
        QVERIFY2(score->precision > 0.9999, (solid.id + " " + std::to_string(score->precision)).c_str());
        QVERIFY(score->resultLength > 0.3 * solid.diagonal());
    }
}

void EvaluationTest::smoothResultsHaveNoCreases()
{
    const Solid box = bevelledBox();
    const auto score = creaseScore(ellipsoid().mesh, truthOf(box));
    QVERIFY(score.ok());
    QCOMPARE(score->recall, 0.0);
    QCOMPARE(score->resultLength, 0.0);
}

void EvaluationTest::creasesAreLostBeyondTheTolerance()
{
    const Solid solid = house();
    const GroundTruth truth = truthOf(solid);
    const Vec3 direction = Vec3(1, 1, 1).normalized();
    QVERIFY(creaseScore(moved(solid.mesh, 0.009 * solid.diagonal() * direction), truth)->recall > 0.9999);
    // At 1.5 % along (1, 1, 1) every edge along an axis is 1.2 % away.
    const auto far = creaseScore(moved(solid.mesh, 0.015 * solid.diagonal() * direction), truth);
    QVERIFY(far->recall < 0.5);
    QVERIFY(far->precision < 0.5);
    QVERIFY(
        creaseScore(moved(solid.mesh, 0.015 * solid.diagonal() * direction), truth, {.creaseTolerance = 0.02})
            ->recall > 0.9999);
}

void EvaluationTest::regionsAreCountedAsConnected()
{
    for (const SolidEntry &entry : allSolids()) {
        const Solid solid = entry.make();
        QCOMPARE(*regionCountRatio(solid.mesh, solid.triangleFaces, truthOf(solid)), 1.0);
    }
    // Opposite walls with one label are still two regions.
    const Solid box = bevelledBox();
    std::vector<int> labels = box.triangleFaces;
    for (int &label : labels)
        if (box.faceNames[std::size_t(label)] == "back")
            label = 0; // front
    QCOMPARE(regionCount(box.mesh, labels), box.faceCount());
    QCOMPARE(regionCount(box.mesh, std::vector<int>(labels.size(), 3)), 1);
}

void EvaluationTest::segmentIndexAgreesWithBruteForce()
{
    Random random(5);
    const auto point = [&](double size) {
        const double x = random.uniform(-size, size), y = random.uniform(-size, size),
                     z = random.uniform(-size, size);
        return Vec3(x, y, z);
    };
    std::vector<Segment> segments;
    for (int i = 0; i < 60; ++i) {
        const Vec3 a = point(1.0), along = point(0.5);
        segments.push_back({a, a + along});
    }
    const SegmentIndex index(segments, 0.1);
    int inside = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 query = point(1.2);
        double nearest = 1e300;
        for (const Segment &segment : segments)
            nearest = std::min(nearest, distanceToSegment(query, segment));
        for (const double distance : {0.03, 0.07, 0.1})
            QCOMPARE(index.isWithin(query, distance), nearest <= distance);
        inside += nearest <= 0.1;
    }
    QVERIFY(inside > 100 && inside < 2900);
}

void EvaluationTest::brokenInputIsRefused()
{
    const Solid solid = house();
    QCOMPARE(surfaceDeviation(TriangleMesh(), solid.mesh).error().code, ErrorCode::TooLittleData);
    QCOMPARE(surfaceDeviation(solid.mesh, TriangleMesh()).error().code, ErrorCode::TooLittleData);
    TriangleMesh broken = solid.mesh;
    broken.triangles[0][1] = broken.vertexCount();
    QCOMPARE(surfaceDeviation(broken, solid.mesh).error().code, ErrorCode::InvalidArgument);
    QCOMPARE(creaseScore(broken, truthOf(solid)).error().code, ErrorCode::InvalidArgument);
    broken = solid.mesh;
    broken.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(surfaceDeviation(broken, solid.mesh).error().code, ErrorCode::InvalidArgument);
    TriangleMesh flat;
    flat.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
    flat.triangles = {{0, 1, 2}};
    QCOMPARE(surfaceDeviation(flat, solid.mesh).error().code, ErrorCode::TooLittleData);
    QCOMPARE(strokeDeviation(StrokeSet(), solid.mesh).error().code, ErrorCode::TooLittleData);
    QCOMPARE(regionCountRatio(solid.mesh, {1, 2}, truthOf(solid)).error().code, ErrorCode::InvalidArgument);
    QCOMPARE(creaseScore(solid.mesh, GroundTruth()).error().code, ErrorCode::TooLittleData);
}

QTEST_APPLESS_MAIN(EvaluationTest)
#include "evaluation_test.moc"
