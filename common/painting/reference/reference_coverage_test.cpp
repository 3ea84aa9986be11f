// Which points strokes and shapes of the reference colour: inside, within tolerance, in order, once.
#include "painting/reference/reference_frame.h"

#include "support/painting_prober.h"

#include <QtTest>
#include <set>

using namespace ductus;
using Eigen::Vector3d;

class ReferenceCoverageTest : public QObject
{
    Q_OBJECT
private slots:
    void coloursWhereStrokesIntersect();
    void coloursWithTheCameraInsideAStroke();
    void aStrokeColoursAPointOnce();
    void strokesCompositeInDrawingOrder();
    void marksKeepTheirWidthFromAllSides_data();
    void marksKeepTheirWidthFromAllSides();
    void bothEyesSeeTheSameMark_data();
    void bothEyesSeeTheSameMark();
    void marksHaveNoGapsOnBumps();
    void toleranceReachesSoFarAndNoFurther();
    void viewToleranceIsADifferenceOfDepth();
    void meshesColourAndAreColoured();
};

void ReferenceCoverageTest::coloursWhereStrokesIntersect()
{
    const PaintingScene scene = intersectionFromOutside();
    const Prober prober(scene);
    // The coat is a round stroke between these, of half width 0.25.
    const Vec3 a(-0.5, 0.5, 0.2), b(0.6, -0.4, 0.2);
    int coloured = 0, plain = 0;
    for (double x = -1; x <= 1; x += 0.02)
        for (double y = -0.6; y <= 0.6; y += 0.02) {
            const Probe probe = prober.towards({x, y, 0});
            if (!probe.point)
                continue;
            const Vec3 p = probe.point->position;
            const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
            const double distance = (p - a - t * (b - a)).norm();
            if (probe.point->stack == 1) {
                QVERIFY(near(probe.colour, green)); // another stack's
            } else if (std::abs(distance - 0.25) > 1e-4) {
                QVERIFY(near(probe.colour, distance < 0.25 ? blue : paper));
                ++(distance < 0.25 ? coloured : plain);
            }
        }
    QVERIFY(coloured > 500 && plain > 500);
}

void ReferenceCoverageTest::coloursWithTheCameraInsideAStroke()
{
    const PaintingScene scene = cameraInsideAStroke();
    QVERIFY((scene.camera.eye - Vec3(-4.8, 0, 0)).norm() < 5.2); // it is inside
    const Prober prober(scene);
    int coloured = 0, plain = 0;
    for (double x = -1; x <= 1; x += 0.02)
        for (double y = -0.5; y <= 0.5; y += 0.02) {
            const Probe probe = prober.towards({x, y, 0});
            if (!probe.point)
                continue;
            const double distance = (probe.point->position - Vec3(-4.8, 0, 0)).norm();
            const Vector3d own = encodedFromLinear(probe.point->colour.cast<double>());
            const Vector3d under = own.cwiseProduct(encoded(0.35f, 0.05f, 0.5f));
            if (std::abs(distance - 5.2) > 1e-3)
                QVERIFY(near(probe.colour, distance < 5.2 ? under : own));
            ++(distance < 5.2 ? coloured : plain);
        }
    QVERIFY(coloured > 500 && plain > 200);
}

void ReferenceCoverageTest::aStrokeColoursAPointOnce()
{
    const ReferenceFrame frame = frameOf(selfOverlap(), 240);
    std::set<Rgba> colours;
    for (int y = 0; y < frame.colour.height; ++y)
        for (int x = 0; x < frame.colour.width; ++x)
            if (frame.stack[std::size_t(y * frame.colour.width + x)] >= 0)
                colours.insert(frame.colour.at(x, y));
    QCOMPARE(colours.size(), std::size_t(2)); // paper, and paper under one coat
    const Vector3d coat = 0.5 * paper + 0.5 * blue;
    const Rgba expected{std::uint8_t(std::lround(255 * coat[0])), std::uint8_t(std::lround(255 * coat[1])),
                        std::uint8_t(std::lround(255 * coat[2])), 255};
    QVERIFY(colours.contains(expected));
}

void ReferenceCoverageTest::strokesCompositeInDrawingOrder()
{
    const Prober prober(strokeOrder());
    const auto coat = [](const Vector3d &below, const Vector3d &colour) {
        return Vector3d(0.4 * below + 0.6 * colour);
    };
    QVERIFY(near(prober.towards({0, -0.2, 0}).colour, coat(paper, blue)));
    QVERIFY(near(prober.towards({-0.4, -0.2, 0}).colour, coat(coat(paper, blue), red)));
    QVERIFY(near(prober.towards({-0.4, 0.3, 0}).colour, coat(coat(paper, red), green)));
    QVERIFY(near(prober.towards({0.4, 0.3, 0}).colour, yellow)); // opaque, drawn last
    PaintingScene turned = strokeOrder();
    auto &elements = turned.painting.stacks[0].appearance[0].drawings[0].elements;
    std::reverse(elements.begin(), elements.end());
    const Prober other(turned);
    QVERIFY(near(other.towards({-0.4, -0.2, 0}).colour, coat(coat(paper, red), blue)));
}

void ReferenceCoverageTest::marksKeepTheirWidthFromAllSides_data()
{
    QTest::addColumn<int>("view");
    for (int view = 0; view < 7; ++view)
        QTest::addRow("%d", view) << view;
}

void ReferenceCoverageTest::marksKeepTheirWidthFromAllSides()
{
    QFETCH(int, view);
    const Prober prober(toleranceOnFlat(view));
    /// The last place of the plate from \a from in direction \a step that is red.
    const auto edge = [&](const Vec3 &from, const Vec3 &step) {
        double low = 0, high = 1;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            (isRed(prober.towards(from + middle * step)) ? low : high) = middle;
        }
        return low;
    };
    for (double x = -0.6; x <= 0.6; x += 0.1) {
        const Vec3 from(x, 0, 0);
        QVERIFY(isRed(prober.towards(from)));
        const double width = edge(from, {0, 0.6, 0}) * 0.6 + edge(from, {0, -0.6, 0}) * 0.6;
        QVERIFY2(std::abs(width - 0.2) < 0.02 * 0.2, qPrintable(QString::number(width)));
    }
    const double length = edge(Vec3::Zero(), {1, 0, 0}) + edge(Vec3::Zero(), {-1, 0, 0});
    QVERIFY2(std::abs(length - 1.6) < 0.02 * 1.6, qPrintable(QString::number(length))); // with round ends
}

void ReferenceCoverageTest::bothEyesSeeTheSameMark_data()
{
    QTest::addColumn<bool>("bumpy");
    QTest::newRow("flat") << false;
    QTest::newRow("bumpy") << true;
}

void ReferenceCoverageTest::bothEyesSeeTheSameMark()
{
    QFETCH(bool, bumpy);
    std::vector<Prober> probers;
    for (int view = 0; view < 7; ++view)
        probers.emplace_back(bumpy ? toleranceOnBumps(view) : toleranceOnFlat(view));
    int compared = 0, marked = 0;
    for (double x = -0.9; x <= 0.9; x += 0.031)
        for (double y = -0.3; y <= 0.3; y += 0.013) {
            const Probe first = probers[5].towards({x, y, -0.02});
            if (!first.point)
                continue;
            for (const Prober &other : probers) {
                const Probe second = other.towards(first.point->position);
                if (!second.point || (second.point->position - first.point->position).norm() > 1e-6)
                    continue; // hidden from there
                // Borders are sharp: a point on one may fall to either side by rounding.
                if (isRed(first) != isRed(second)) {
                    const Vec3 aside = first.point->position + Vec3(1e-5, 1e-5, 0);
                    QVERIFY(isRed(probers[5].towards(aside)) != isRed(first));
                }
                ++compared;
                marked += isRed(first);
            }
        }
    QVERIFY(compared > 5000 && marked > 1000);
}

void ReferenceCoverageTest::marksHaveNoGapsOnBumps()
{
    for (int view = 0; view < 7; ++view) {
        const Prober prober(toleranceOnBumps(view));
        int seen = 0;
        for (double x = -0.65; x <= 0.65; x += 0.007)
            for (double y = -0.085; y <= 0.085; y += 0.017) {
                const Probe probe = prober.towards({x, y, -0.01});
                if (!probe.point || std::abs(probe.point->position.y()) > 0.085)
                    continue;
                ++seen;
                QVERIFY2(isRed(probe), qPrintable(QString("view %1 at %2 %3").arg(view).arg(x).arg(y)));
            }
        QVERIFY(seen > 1000);
    }
}

void ReferenceCoverageTest::toleranceReachesSoFarAndNoFurther()
{
    const Prober prober(toleranceReach());
    for (double x = -0.75; x <= 0.75; x += 0.05)
        for (double y = -0.09; y <= 0.09; y += 0.03) {
            QVERIFY(isRed(prober.towards({x, 0.5 + y, 0})));
            QVERIFY(isRed(prober.towards({x, y, 0})));
            QVERIFY(near(prober.towards({x, -0.5 + y, 0}).colour, paper));
        }
}

void ReferenceCoverageTest::viewToleranceIsADifferenceOfDepth()
{
    const PaintingScene scene = toleranceOfView();
    const Prober prober(scene);
    const Vec3 a(-0.7, 0, 0.05), b(0.7, 0, 0.05);
    const Vec3 forward = -(scene.camera.rotation * Vec3::UnitZ());
    int marked = 0, plain = 0;
    for (double x = -0.9; x <= 0.9; x += 0.043)
        for (double y = -0.4; y <= 0.4; y += 0.023) {
            const Probe probe = prober.towards({x, y, 0});
            if (!probe.point)
                continue;
            const Vec3 ray = (probe.point->position - scene.camera.eye) / probe.point->depth;
            QVERIFY(std::abs(ray.dot(forward) - 1) < 1e-9);
            bool expected = false; // some place of the ray, no more than 0.08 deeper or nearer, is inside
            for (int i = -400; i <= 400 && !expected; ++i) {
                const Vec3 p = probe.point->position + 0.08 * i / 400.0 * ray;
                const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
                expected = (p - a - t * (b - a)).norm() <= 0.1 - 1e-4;
            }
            QVERIFY(!expected || isRed(probe));
            ++(isRed(probe) ? marked : plain);
        }
    QVERIFY(marked > 200 && plain > 400);
}

void ReferenceCoverageTest::meshesColourAndAreColoured()
{
    const Prober prober(meshes());
    int cut = 0, near_ = 0, plain = 0;
    for (double x = -0.6; x <= 0.6; x += 0.02)
        for (double y = -0.6; y <= 0.6; y += 0.02) {
            const Probe probe = prober.towards({x, y, 0.4});
            if (!probe.point)
                continue;
            const double distance = (probe.point->position - Vec3(0.4, 0.3, 0.4)).norm();
            if (distance < 0.33)
                QVERIFY(near(probe.colour, blue, 1e-5));
            else if (distance > 0.351)
                QVERIFY(!near(probe.colour, blue, 1e-5));
            ++(near(probe.colour, blue, 1e-5) ? cut : near(probe.colour, red, 1e-5) ? near_ : plain);
        }
    QVERIFY(cut > 50 && near_ > 50 && plain > 500);
}

QTEST_APPLESS_MAIN(ReferenceCoverageTest)
#include "reference_coverage_test.moc"
