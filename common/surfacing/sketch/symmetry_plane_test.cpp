#include "surfacing/sketch/symmetry_plane.h"

#include "base/random.h"

#include <QtTest>

using namespace ductus;

namespace {

Vec3 randomVec(Random &random)
{
    const double x = random.uniform(-1.0, 1.0), y = random.uniform(-1.0, 1.0);
    return {x, y, random.uniform(-1.0, 1.0)};
}

// Smooth random arcs in a box that is longer than wide, so that no other plane comes near.
StrokeSet randomSketch(int strokes, std::uint64_t seed)
{
    Random random(seed);
    StrokeSet set;
    for (int s = 0; s < strokes; ++s) {
        const Vec3 a = randomVec(random), b = randomVec(random), c = randomVec(random);
        Stroke stroke;
        stroke.id.value = s;
        for (int i = 0; i <= 30; ++i) {
            const double t = i / 30.0;
            const Vec3 p = (1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * c;
            stroke.points.push_back(p.cwiseProduct(Vec3(0.6, 1.0, 1.7)));
        }
        set.strokes.push_back(stroke);
    }
    return set;
}

// Only what lies on the kept side, and its mirror image, some of it shaken as a hand would.
StrokeSet mirroredSketch(const SymmetryPlane &plane, double noise)
{
    StrokeSet whole = withMirrorImage(keptHalf(randomSketch(24, 5), plane), plane);
    Random random(2);
    for (Stroke &stroke : whole.strokes) {
        const Vec3 shift = noise * randomVec(random);
        for (Vec3 &p : stroke.points)
            p += shift;
    }
    return whole;
}

double angleDegrees(const Vec3 &a, const Vec3 &b)
{
    return std::acos(std::min(1.0, std::abs(a.dot(b)))) * 57.29577951308232;
}

double lengthOf(const StrokeSet &set)
{
    double sum = 0.0;
    for (const Stroke &stroke : set.strokes)
        sum += polylineLength(stroke.points);
    return sum;
}

} // namespace

class SymmetryPlaneTest : public QObject
{
    Q_OBJECT
private slots:
    void mirrorsAndProjects();
    void detectsThePlaneOfAMirroredSketch_data();
    void detectsThePlaneOfAMirroredSketch();
    void axisPlanesAreExact();
    void asymmetricSketchHasNone();
    void tooLittleHasNone();
    void strictnessIsTheUsers();
    void turnsTowardsTheFullerSide();
    void keptHalfIsCutExactly();
    void keptHalfKeepsChannelsIdsAndRoles();
    void strokesInThePlaneAreKept();
    void mirrorImageDoublesTheSketch();
};

void SymmetryPlaneTest::mirrorsAndProjects()
{
    const SymmetryPlane plane{Vec3(2, 1, -2) / 3.0, 0.4};
    Random random(1);
    for (int i = 0; i < 50; ++i) {
        const Vec3 p = randomVec(random);
        QVERIFY(std::abs(plane.signedDistance(plane.mirrored(p)) + plane.signedDistance(p)) < 1e-14);
        QVERIFY(std::abs(plane.signedDistance(plane.projected(p))) < 1e-14);
        QVERIFY((plane.mirrored(plane.mirrored(p)) - p).norm() < 1e-14);
        QVERIFY((0.5 * (p + plane.mirrored(p)) - plane.projected(p)).norm() < 1e-14);
    }
}

void SymmetryPlaneTest::detectsThePlaneOfAMirroredSketch_data()
{
    QTest::addColumn<Vec3>("normal");
    QTest::addColumn<double>("offset");
    QTest::addColumn<double>("noise");
    QTest::newRow("x") << Vec3(Vec3::UnitX()) << 0.0 << 0.0;
    QTest::newRow("y beside the origin") << Vec3(Vec3::UnitY()) << 0.3 << 0.0;
    QTest::newRow("z, drawn by hand") << Vec3(Vec3::UnitZ()) << -0.2 << 0.008;
    QTest::newRow("oblique") << Vec3(Vec3(3, 1, 2).normalized()) << 0.1 << 0.0;
    QTest::newRow("oblique, drawn by hand") << Vec3(Vec3(-1, 2, 1).normalized()) << 0.0 << 0.008;
    QTest::newRow("nearly an axis") << Vec3(Vec3(1, 0.08, 0).normalized()) << 0.1 << 0.0;
}

void SymmetryPlaneTest::detectsThePlaneOfAMirroredSketch()
{
    QFETCH(Vec3, normal);
    QFETCH(double, offset);
    QFETCH(double, noise);
    const StrokeSet sketch = mirroredSketch({normal, offset}, noise);
    const auto found = detectSymmetry(sketch, {});
    QVERIFY(found.has_value());
    const double diagonal = sketch.box().diagonal();
    QVERIFY2(angleDegrees(found->plane.normal, normal) < 0.5,
             qPrintable(QString::number(angleDegrees(found->plane.normal, normal))));
    QVERIFY(std::abs(found->plane.normal.norm() - 1.0) < 1e-12);
    const double sign = found->plane.normal.dot(normal) > 0 ? 1.0 : -1.0;
    QVERIFY(std::abs(sign * found->plane.offset - offset) < 0.004 * diagonal);
    QVERIFY(found->matchedShare >= 0.85 && found->matchedShare <= 1.0);
    QVERIFY(found->residual >= 0.0 && found->residual < 0.012 * diagonal);
}

void SymmetryPlaneTest::axisPlanesAreExact()
{
    const auto found = detectSymmetry(mirroredSketch({Vec3::UnitY(), 0.3}, 0.002), {});
    QVERIFY(found.has_value());
    QCOMPARE(found->plane.normal.cwiseAbs(), Vec3(0, 1, 0)); // mirror tools work in axes
}

void SymmetryPlaneTest::asymmetricSketchHasNone()
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
        QVERIFY(!detectSymmetry(randomSketch(30, seed), {}).has_value());
    // Half of it mirrored is not enough.
    StrokeSet partly = mirroredSketch({Vec3::UnitX(), 0.0}, 0.0);
    const StrokeSet extra = randomSketch(30, 77);
    partly.strokes.insert(partly.strokes.end(), extra.strokes.begin(), extra.strokes.end());
    QVERIFY(!detectSymmetry(partly, {}).has_value());
}

void SymmetryPlaneTest::tooLittleHasNone()
{
    QVERIFY(!detectSymmetry({}, {}).has_value());
    StrokeSet point;
    point.strokes.resize(2);
    point.strokes[0].points = {{1, 2, 3}, {1, 2, 3}};
    QVERIFY(!detectSymmetry(point, {}).has_value());
}

void SymmetryPlaneTest::strictnessIsTheUsers()
{
    const StrokeSet sketch = mirroredSketch({Vec3::UnitX(), 0.0}, 0.02);
    SymmetryOptions strict, loose;
    strict.tolerance = 0.001;
    loose.tolerance = 0.03;
    QVERIFY(!detectSymmetry(sketch, strict).has_value());
    QVERIFY(detectSymmetry(sketch, loose).has_value());
}

void SymmetryPlaneTest::turnsTowardsTheFullerSide()
{
    const StrokeSet sketch = keptHalf(randomSketch(20, 4), {Vec3::UnitX(), 0.0});
    for (const SymmetryPlane &plane :
         {SymmetryPlane{Vec3::UnitX(), 0.1}, SymmetryPlane{-Vec3::UnitX(), -0.1}}) {
        const SymmetryPlane turned = towardsFullerSide(plane, sketch);
        QCOMPARE(turned.normal, Vec3(Vec3::UnitX()));
        QCOMPARE(turned.offset, 0.1);
    }
}

void SymmetryPlaneTest::keptHalfIsCutExactly()
{
    const StrokeSet sketch = randomSketch(40, 8);
    const SymmetryPlane plane{Vec3(1, -2, 2) / 3.0, 0.15};
    const StrokeSet half = keptHalf(sketch, plane);
    const double tolerance = 1e-4 * sketch.box().diagonal();
    int cuts = 0;
    for (const Stroke &stroke : half.strokes) {
        QVERIFY(stroke.points.size() >= 2);
        for (const Vec3 &p : stroke.points) {
            QVERIFY(plane.signedDistance(p) >= -tolerance);
            cuts += std::abs(plane.signedDistance(p)) < 1e-12;
        }
    }
    QVERIFY(cuts > 10);
    double length = 0.0; // on the kept side, by sampling finely
    for (const Stroke &stroke : sketch.strokes)
        for (std::size_t i = 1; i < stroke.points.size(); ++i) {
            const Vec3 a = stroke.points[i - 1], b = stroke.points[i];
            for (int k = 0; k < 1000; ++k)
                if (plane.signedDistance(a + (k + 0.5) / 1000 * (b - a)) >= 0.0)
                    length += (b - a).norm() / 1000;
        }
    QVERIFY(std::abs(lengthOf(half) / length - 1.0) < 1e-3);
    // Both halves together are the sketch.
    const double other = lengthOf(keptHalf(sketch, {-plane.normal, -plane.offset}));
    QVERIFY(std::abs((lengthOf(half) + other) / lengthOf(sketch) - 1.0) < 1e-3);
}

void SymmetryPlaneTest::keptHalfKeepsChannelsIdsAndRoles()
{
    StrokeSet sketch;
    Stroke wave; // crosses the plane four times
    wave.id.value = 17;
    wave.role = StrokeRole::Boundary;
    for (int i = 0; i <= 40; ++i) {
        wave.points.push_back({std::sin(0.4 * i + 0.1), 0.1 * i, 0.0});
        wave.timeSeconds.push_back(0.1 * i);
        wave.pressure.push_back(0.02 * i);
    }
    sketch.strokes = {wave};
    const StrokeSet half = keptHalf(sketch, {Vec3::UnitX(), 0.0});
    QVERIFY(half.strokes.size() >= 2);
    for (const Stroke &piece : half.strokes) {
        QCOMPARE(piece.id.value, 17);
        QVERIFY(piece.role == StrokeRole::Boundary);
        QCOMPARE(piece.timeSeconds.size(), piece.points.size());
        QCOMPARE(piece.pressure.size(), piece.points.size());
        for (std::size_t i = 0; i < piece.points.size(); ++i) { // both are linear in y
            QVERIFY(std::abs(piece.timeSeconds[i] - piece.points[i].y()) < 1e-12);
            QVERIFY(std::abs(piece.pressure[i] - 0.2 * piece.points[i].y()) < 1e-12);
        }
    }
}

void SymmetryPlaneTest::strokesInThePlaneAreKept()
{
    StrokeSet sketch = randomSketch(5, 1);
    Stroke spine;
    for (int i = 0; i <= 20; ++i) // a little to the wrong side, as rounding has it
        spine.points.push_back({-1e-9, 0.1 * i, std::sin(0.1 * i)});
    sketch.strokes = {spine};
    const StrokeSet half = keptHalf(sketch, {Vec3::UnitX(), 0.0});
    QCOMPARE(half.strokes.size(), std::size_t(1));
    QCOMPARE(half.strokes[0].points.size(), spine.points.size());
}

void SymmetryPlaneTest::mirrorImageDoublesTheSketch()
{
    const SymmetryPlane plane{Vec3(0, 3, 4) / 5.0, -0.2};
    const StrokeSet half = keptHalf(randomSketch(10, 3), plane);
    const StrokeSet whole = withMirrorImage(half, plane);
    QCOMPARE(whole.strokes.size(), 2 * half.strokes.size());
    for (std::size_t s = 0; s < half.strokes.size(); ++s) {
        QCOMPARE(whole.strokes[s].points, half.strokes[s].points);
        const Stroke &image = whole.strokes[s + half.strokes.size()];
        QCOMPARE(image.points.size(), half.strokes[s].points.size());
        for (std::size_t i = 0; i < image.points.size(); ++i)
            QVERIFY((image.points[i] - plane.mirrored(half.strokes[s].points[i])).norm() < 1e-14);
    }
}

QTEST_APPLESS_MAIN(SymmetryPlaneTest)
#include "symmetry_plane_test.moc"
