#include "painting/coverage/section.h"

#include "base/random.h"
#include "painting/coverage/stroke_segments.h"
#include "painting/scene/placement.h"

#include <QtTest>

using namespace ductus;

namespace {

Vec3 randomVector(Random &random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

/// Wanders with bends up to \a bend (radians) and widths between 0.1 and 0.4, tapered to 0 at both ends.
StrokeShape wanderingStroke(StrokeSection section, std::uint64_t seed, double bend, double step = 0.5)
{
    Random random(seed);
    StrokeShape stroke;
    stroke.section = section;
    Vec3 position = Vec3::Zero(), heading = Vec3::UnitX(), normal = Vec3::UnitY();
    const int count = 12;
    for (int i = 0; i < count; ++i) {
        PaintedPoint point;
        point.position = position.cast<float>();
        point.normal = normal.cast<float>();
        point.halfWidth = i == 0 || i == count - 1 ? 0.f : float(random.uniform(0.1, 0.4));
        stroke.points.push_back(point);
        heading =
            (Eigen::AngleAxisd(random.uniform(-bend, bend), randomVector(random, 1).normalized()) * heading);
        normal = (normal + 0.2 * randomVector(random, 1)).normalized();
        position += step * heading;
    }
    return stroke;
}

std::vector<SegmentData> segmentsOf(const StrokeShape &stroke,
                                    const Eigen::Affine3d &place = Eigen::Affine3d::Identity())
{
    std::vector<SegmentData> segments;
    appendStrokeSegments(stroke, place, 0, std::nullopt, segments);
    return segments;
}

bool containsAny(const std::vector<SegmentData> &segments, const Vec3 &x)
{
    return std::any_of(segments.begin(), segments.end(),
                       [&](const SegmentData &segment) { return segmentContains(segment, x); });
}

/// Nearest crossing of the skin of the whole stroke.
std::optional<double> surfaceOf(const std::vector<SegmentData> &segments, const Vec3 &o, const Vec3 &d,
                                double from = 0)
{
    std::optional<double> nearest;
    for (const SegmentData &segment : segments)
        if (const auto s = segmentSurface(segment, o, d, from); s && (!nearest || *s < *nearest))
            nearest = s;
    return nearest;
}

} // namespace

class SectionTest : public QObject
{
    Q_OBJECT
private slots:
    void linesMeetTheSolidInOneInterval_data();
    void linesMeetTheSolidInOneInterval();
    void skinIsClosed_data();
    void skinIsClosed();
    void insideIsSeenFromInside();
    void roundIsTheHullOfBalls();
    void cuttingAtJointsLosesNothing();
    void sectionsHaveQuillsHeights();
    void mirroredStrokesAreMirrorImages();
    void boxesHoldEverything();
    void reachIsNoFurtherThanTolerance();
    void aFarCameraSeesThinStrokes();
    void dabs();
    void ribbonsHaveNoInside();
};

void SectionTest::linesMeetTheSolidInOneInterval_data()
{
    QTest::addColumn<int>("section");
    QTest::newRow("round") << 0;
    QTest::newRow("ellipse") << 1;
    QTest::newRow("cube") << 2;
}

void SectionTest::linesMeetTheSolidInOneInterval()
{
    QFETCH(int, section);
    Random random(7);
    int met = 0;
    for (int stroke = 0; stroke < 20; ++stroke)
        for (const SegmentData &segment :
             segmentsOf(wanderingStroke(StrokeSection(section), std::uint64_t(stroke), 0.7))) {
            const Vec3 middle = 0.5 * (segment.a + segment.b).cast<double>();
            for (int line = 0; line < 20; ++line) {
                const Vec3 through = middle + randomVector(random, 0.4);
                const Vec3 direction = randomVector(random, 2), origin = through - 3 * direction;
                const auto hits = segmentInterval(segment, origin, direction);
                met += hits.has_value();
                for (double s = 1; s <= 5; s += 0.05) {
                    // Points that are within rounding of the skin may be on either side.
                    const bool expected = hits && s > hits->first + 1e-6 && s < hits->second - 1e-6;
                    const bool open =
                        hits && (std::abs(s - hits->first) <= 1e-6 || std::abs(s - hits->second) <= 1e-6);
                    if (!open)
                        QCOMPARE(segmentContains(segment, origin + s * direction), expected);
                }
            }
        }
    QVERIFY(met > 500);
}

void SectionTest::skinIsClosed_data()
{
    linesMeetTheSolidInOneInterval_data();
}

/// From outside a line to a point inside crosses skin before that point, and behind it. Where neighbours of
/// different width share a plane there are slits of a two hundredth of the width.
void SectionTest::skinIsClosed()
{
    QFETCH(int, section);
    Random random(3);
    int tried = 0, leaks = 0;
    for (int stroke = 0; stroke < 40; ++stroke) {
        const auto segments =
            segmentsOf(wanderingStroke(StrokeSection(section), 100 + std::uint64_t(stroke), 0.7));
        for (const SegmentData &segment : segments)
            for (int line = 0; line < 40; ++line) {
                const double t = random.uniform();
                const Vec3 inside = ((1 - t) * segment.a + t * segment.b).cast<double>();
                const Vec3 direction = randomVector(random, 1).normalized(), origin = inside - 20 * direction;
                if (!containsAny(segments, inside) || std::max(segment.radiusA, segment.radiusB) == 0)
                    continue;
                ++tried;
                const auto s = surfaceOf(segments, origin, direction);
                leaks += !s || *s > 20 + 1e-6 || !surfaceOf(segments, origin, direction, 20.0);
            }
    }
    QVERIFY(tried > 5000);
    QVERIFY2(leaks <= tried / 2000, qPrintable(QString("%1 of %2").arg(leaks).arg(tried)));
}

void SectionTest::insideIsSeenFromInside()
{
    StrokeShape huge;
    for (int i = 0; i < 5; ++i)
        huge.points.push_back({{float(i), 0, 0}, {0, 1, 0}, i == 0 || i == 4 ? 0.f : 1.f});
    const auto segments = segmentsOf(huge);
    const auto wall = surfaceOf(segments, {2.2, 0, 0}, {0, 1, 0});
    QVERIFY(wall && std::abs(*wall - 1) < 1e-6); // not the planes between segments
    const auto along = surfaceOf(segments, {2.2, 0, 0}, {1, 0, 0});
    QVERIFY(along && std::abs(*along - 1.8) < 1e-2);
}

void SectionTest::roundIsTheHullOfBalls()
{
    StrokeShape cone;
    cone.points.push_back({{0, 0, 0}, {0, 1, 0}, 0.5f});
    cone.points.push_back({{2, 0, 0}, {0, 1, 0}, 0.2f});
    const auto segments = segmentsOf(cone);
    QCOMPARE(segments.size(), std::size_t(1));
    Random random(11);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 x = Vec3(1, 0, 0) + randomVector(random, 1.8);
        bool expected = false; // a hull of balls is the union of all balls between
        for (int k = 0; k <= 2000 && !expected; ++k) {
            const double t = k / 2000.0;
            expected = (x - Vec3(2 * t, 0, 0)).norm() <= 0.5 - 0.3 * t;
        }
        inside += expected;
        if (segmentContains(segments[0], x) != expected) { // only within the sampling of the union
            const Vec3 inward = 1e-4 * (Vec3(1, 0, 0) - x).normalized();
            QVERIFY(segmentContains(segments[0], x) && segmentContains(segments[0], x + inward));
        }
    }
    QVERIFY(inside > 300);
}

/// The planes between neighbours must not cut holes, also where hands trembled over points much denser than
/// the stroke is wide.
void SectionTest::cuttingAtJointsLosesNothing()
{
    Random random(5);
    int whole = 0, lost = 0;
    for (int stroke = 0; stroke < 60; ++stroke) {
        const double step = stroke % 3 == 0 ? 0.5 : stroke % 3 == 1 ? 0.1 : 0.03;
        auto segments = segmentsOf(
            wanderingStroke(StrokeSection::Round, 200 + std::uint64_t(stroke), stroke % 2 ? 1.2 : 0.5, step));
        auto uncut = segments;
        for (SegmentData &segment : uncut)
            segment.clipA = segment.clipB = Eigen::Vector3f::Zero();
        for (const SegmentData &segment : uncut)
            for (int i = 0; i < 100; ++i) {
                const Vec3 x = segment.a.cast<double>() + randomVector(random, 0.4);
                if (!containsAny(uncut, x))
                    continue;
                ++whole;
                lost += !containsAny(segments, x);
            }
    }
    QVERIFY(whole > 20000);
    QVERIFY2(lost < whole / 200, qPrintable(QString("%1 of %2").arg(lost).arg(whole)));
}

void SectionTest::sectionsHaveQuillsHeights()
{
    for (const StrokeSection section :
         {StrokeSection::Round, StrokeSection::Ellipse, StrokeSection::Cube, StrokeSection::Ribbon}) {
        StrokeShape stroke;
        stroke.section = section;
        for (int i = 0; i < 3; ++i)
            stroke.points.push_back({{float(i), 0, 0}, {0, 0, 1}, 0.5f});
        const auto segments = segmentsOf(stroke);
        // T = x, U = normal x T = y, V = T x U = z
        const auto height = [&](const Vec3 &direction, const Vec3 &offset = Vec3::Zero()) {
            const auto s = surfaceOf(segments, Vec3(0.7, 0, 0) + offset + 5 * direction, -direction);
            return s ? 5 - *s : -1.0;
        };
        const double y = height(Vec3::UnitY()), z = height(Vec3::UnitZ());
        switch (section) {
        case StrokeSection::Round:
            QVERIFY(std::abs(y - 0.5) < 1e-6 && std::abs(z - 0.5) < 1e-6);
            break;
        case StrokeSection::Ellipse:
            QVERIFY(std::abs(y - 0.5) < 1e-6 && std::abs(z - 0.15) < 1e-6);
            break;
        case StrokeSection::Cube:
            QVERIFY(std::abs(y - 0.5) < 1e-6 && std::abs(z - 0.5) < 1e-6);
            QVERIFY(std::abs(height(Vec3::UnitZ(), {0, 0.499, 0}) - 0.5) < 1e-6);
            break;
        case StrokeSection::Ribbon:
            QVERIFY(y == -1 && std::abs(z) < 1e-6); // seen from its edge it is nothing
            QVERIFY(std::abs(height(Vec3::UnitZ(), {0, 0.499, 0})) < 1e-6);
            QVERIFY(height(Vec3::UnitZ(), {0, 0.501, 0}) == -1);
            break;
        }
    }
}

void SectionTest::mirroredStrokesAreMirrorImages()
{
    Placement mirror;
    mirror.mirrored = true;
    Random random(17);
    for (const StrokeSection section : {StrokeSection::Round, StrokeSection::Ellipse, StrokeSection::Cube}) {
        const StrokeShape stroke = wanderingStroke(section, 31, 0.6);
        const auto one = segmentsOf(stroke), other = segmentsOf(stroke, mirror.matrix());
        int inside = 0;
        for (int i = 0; i < 5000; ++i) {
            const Vec3 x =
                one[std::size_t(random.index(int(one.size())))].a.cast<double>() + randomVector(random, 0.3);
            inside += containsAny(one, x);
            QCOMPARE(containsAny(one, x), containsAny(other, x.cwiseProduct(Vec3(-1, 1, 1))));
        }
        QVERIFY(inside > 500 && inside < 4500);
    }
}

void SectionTest::boxesHoldEverything()
{
    Random random(23);
    for (const StrokeSection section :
         {StrokeSection::Round, StrokeSection::Ellipse, StrokeSection::Cube, StrokeSection::Ribbon})
        for (int stroke = 0; stroke < 10; ++stroke)
            for (SegmentData segment :
                 segmentsOf(wanderingStroke(section, 300 + std::uint64_t(stroke), 0.75))) {
                segment.reachA = randomVector(random, 1).normalized().cast<float>();
                segment.reachB = randomVector(random, 1).normalized().cast<float>();
                const double tolerance = 0.3;
                const SegmentBounds bounds = segmentBounds(segment, tolerance);
                const Box3 box = bounds.box();
                for (int i = 0; i < 200; ++i) {
                    const Vec3 x = segment.a.cast<double>() + randomVector(random, 1.5);
                    if (!segmentReaches(segment, x, tolerance))
                        continue;
                    QVERIFY((x - box.min).minCoeff() >= 0 && (box.max - x).minCoeff() >= 0);
                    for (const Vec3 &axis : bounds.halfAxes)
                        QVERIFY(std::abs((x - bounds.centre).dot(axis)) <= axis.squaredNorm() * (1 + 1e-6));
                }
            }
}

void SectionTest::reachIsNoFurtherThanTolerance()
{
    Random random(29);
    const double tolerance = 0.2;
    int reached = 0;
    for (int stroke = 0; stroke < 20; ++stroke)
        for (SegmentData segment :
             segmentsOf(wanderingStroke(StrokeSection::Round, 400 + std::uint64_t(stroke), 0.7))) {
            segment.reachA = randomVector(random, 1).normalized().cast<float>();
            segment.reachB = (segment.reachA + 0.3f * randomVector(random, 1).cast<float>()).normalized();
            SegmentData wider = segment; // all points nearer than the tolerance
            wider.radiusA += float(tolerance) + 1e-4f;
            wider.radiusB += float(tolerance) + 1e-4f;
            wider.clipA = wider.clipB = Eigen::Vector3f::Zero();
            for (int i = 0; i < 300; ++i) {
                const Vec3 x = segment.a.cast<double>() + randomVector(random, 0.9);
                if (segmentReaches(segment, x, tolerance)) {
                    ++reached;
                    QVERIFY(segmentContains(wider, x));
                }
            }
        }
    QVERIFY(reached > 1000);
}

void SectionTest::aFarCameraSeesThinStrokes()
{
    StrokeShape thread;
    for (int i = 0; i < 3; ++i)
        thread.points.push_back({{float(i) * 0.1f, 0, 0}, {0, 1, 0}, 1e-4f});
    const auto segments = segmentsOf(thread);
    const Vec3 eye(3000, 4000, 12000);
    int seen = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 aim(0.01 + 0.0009 * i, 0.5e-4, 0);
        const auto s = surfaceOf(segments, eye, aim - eye);
        seen += s && std::abs((eye + *s * (aim - eye) - aim).norm()) < 3e-4;
    }
    QCOMPARE(seen, 200);
}

void SectionTest::dabs()
{
    for (const StrokeSection section :
         {StrokeSection::Round, StrokeSection::Ellipse, StrokeSection::Cube, StrokeSection::Ribbon}) {
        StrokeShape dab;
        dab.section = section;
        dab.points.assign(3, {{1, 2, 3}, {0, 0, 1}, 0.5f}); // three times the same place
        const auto segments = segmentsOf(dab);
        QCOMPARE(segments.size(), std::size_t(1));
        const auto top = surfaceOf(segments, {1, 2, 13}, {0, 0, -1});
        QVERIFY(top.has_value());
        QCOMPARE(containsAny(segments, {1, 2, 3}), section != StrokeSection::Ribbon);
        QVERIFY(!containsAny(segments, {1.6, 2, 3}) && !containsAny(segments, {1, 2.6, 3}));
    }
    StrokeShape nothing;
    nothing.points.assign(2, {{1, 2, 3}, {0, 0, 1}, 0.f});
    QVERIFY(segmentsOf(nothing).empty());
}

void SectionTest::ribbonsHaveNoInside()
{
    auto segments = segmentsOf(wanderingStroke(StrokeSection::Ribbon, 9, 0.4));
    for (SegmentData &segment : segments) {
        segment.reachA = segment.u.cross((segment.b - segment.a).normalized()).normalized();
        segment.reachB = segment.reachA;
        const Vec3 middle = 0.5 * (segment.a + segment.b).cast<double>();
        QVERIFY(!segmentContains(segment, middle));
        const Vec3 beside = middle + 0.1 * segmentReach(segment, middle);
        QVERIFY(segmentReaches(segment, beside, 0.15));
        QVERIFY(!segmentReaches(segment, beside, 0.05));
    }
}

QTEST_APPLESS_MAIN(SectionTest)
#include "section_test.moc"
