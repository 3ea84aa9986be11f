#include "surfacing/parts/skeletal_strokes.h"

#include "geometry/mesh_topology.h"

#include <QtTest>

using namespace ductus;

namespace {

Stroke skeletal(int id, const Vec3 &a, const Vec3 &b)
{
    Stroke stroke;
    stroke.id.value = id;
    stroke.role = StrokeRole::Skeletal;
    stroke.points = {a, 0.5 * (a + b), b};
    return stroke;
}

SkeletalTubes tubesOf(const std::vector<Stroke> &strokes, const std::optional<SymmetryPlane> &plane = {})
{
    StrokeSet set;
    set.strokes = strokes;
    SkeletalOptions options;
    options.radius = 0.01;
    return skeletalTubes(set, 10.0, plane, options);
}

} // namespace

class SkeletalStrokesTest : public QObject
{
    Q_OBJECT
private slots:
    void onlySkeletalStrokesGiveTubes();
    void widthIsAShareOfTheDiagonal();
    void pressureIsWidth();
    void mirrorImages();
    void strokesWithoutLengthAreTold();
};

void SkeletalStrokesTest::onlySkeletalStrokesGiveTubes()
{
    std::vector<Stroke> strokes;
    for (StrokeRole role :
         {StrokeRole::Surface, StrokeRole::Boundary, StrokeRole::Ignored, StrokeRole::Inner}) {
        strokes.push_back(skeletal(int(strokes.size()), {0, 0, 0}, {1, 0, 0}));
        strokes.back().role = role;
    }
    QVERIFY(tubesOf(strokes).mesh.isEmpty());
    strokes.push_back(skeletal(7, {0, 0, 0}, {1, 0, 0}));
    strokes.push_back(skeletal(9, {0, 2, 0}, {1, 2, 0}));
    const SkeletalTubes tubes = tubesOf(strokes);
    QCOMPARE(tubes.tubes, (std::vector<StrokeId>{StrokeId{7}, StrokeId{9}}));
    QCOMPARE(tubes.triangleTubes.size(), tubes.mesh.triangles.size());
    QCOMPARE(tubes.triangleTubes.front(), 0);
    QCOMPARE(tubes.triangleTubes.back(), 1);
    QVERIFY(manifoldReport(tubes.mesh).isClosed());
    QCOMPARE(manifoldReport(tubes.mesh).components, 2);
}

void SkeletalStrokesTest::widthIsAShareOfTheDiagonal()
{
    const Box3 box = boundingBox(tubesOf({skeletal(0, {0, 0, 0}, {1, 0, 0})}).mesh.vertices);
    QVERIFY(std::abs(box.max.x() - 1.1) < 1e-9);
    QVERIFY(box.max.y() > 0.095 && box.max.y() < 0.1 + 1e-9);
}

void SkeletalStrokesTest::pressureIsWidth()
{
    const auto halfWidth = [](double pressure) {
        Stroke stroke = skeletal(0, {0, 0, 0}, {5, 0, 0});
        stroke.pressure = {pressure, pressure, pressure};
        return boundingBox(tubesOf({stroke}).mesh.vertices).max.x() - 5.0;
    };
    QVERIFY(std::abs(halfWidth(0.5) - 0.1) < 1e-9);
    QVERIFY(std::abs(halfWidth(1.0) - 0.2) < 1e-9);
    QVERIFY(std::abs(halfWidth(0.0) - 0.02) < 1e-9); // a tube yet
}

void SkeletalStrokesTest::mirrorImages()
{
    const SymmetryPlane plane{Vec3::UnitX(), 0.0};
    const SkeletalTubes kept = tubesOf({skeletal(3, {1, 0, 0}, {2, 1, 0})}, plane);
    QCOMPARE(kept.tubes, (std::vector<StrokeId>{StrokeId{3}, StrokeId{3}}));
    QVERIFY(manifoldReport(kept.mesh).isClosed());
    const Box3 box = boundingBox(kept.mesh.vertices);
    QVERIFY(std::abs(box.min.x() + box.max.x()) < 1e-12);
    TriangleMesh image = kept.mesh; // turned inside out, its volume would be taken off
    image.triangles.erase(image.triangles.begin(), image.triangles.begin() + image.triangleCount() / 2);
    QVERIFY(signedVolume(image) > 0.0);
    QVERIFY(tubesOf({skeletal(3, {-1, 0, 0}, {-2, 1, 0})}, plane).mesh.isEmpty());
    QCOMPARE(tubesOf({skeletal(3, {-1, 0, 0}, {1, 1, 0})}, plane).tubes.size(), std::size_t(1));
    QCOMPARE(tubesOf({skeletal(3, {0, 0, 0}, {0, 1, 0})}, plane).tubes.size(), std::size_t(1));
}

void SkeletalStrokesTest::strokesWithoutLengthAreTold()
{
    const SkeletalTubes tubes =
        tubesOf({skeletal(4, {1, 1, 1}, {1, 1, 1}), skeletal(5, {0, 0, 0}, {1, 0, 0})});
    QCOMPARE(tubes.tubes.size(), std::size_t(1));
    QCOMPARE(tubes.warnings.size(), std::size_t(1));
    QVERIFY(tubes.warnings.front().find("stroke 4") != std::string::npos);
}

QTEST_APPLESS_MAIN(SkeletalStrokesTest)
#include "skeletal_strokes_test.moc"
