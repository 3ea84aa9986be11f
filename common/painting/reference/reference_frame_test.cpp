#include "painting/reference/reference_frame.h"

#include "painting/coverage/mask_value.h"
#include "painting/scene/painting_check.h"
#include "support/painting_scenes.h"

#include <QtTest>
#include <atomic>
#include <set>

using namespace ductus;

namespace {

using Eigen::Vector3d;

struct Probe
{
    std::optional<SubstratePoint> point; // nothing there
    Vector3d colour = Vector3d::Zero();  // in the blend space
};

/// Asks a scene through its camera.
class Prober
{
public:
    explicit Prober(const PaintingScene &scene)
        : mScene(scene), solid(*PaintingSolid::make(scene.painting, scene.moment, {}))
    {
    }

    Probe towards(const Vec3 &target) const { return along(target - mScene.camera.eye); }

    Probe along(Vec3 ray) const
    {
        ray /= (mScene.camera.rotation.conjugate() * ray).z() * -1; // depth grows by 1
        std::vector<SubstratePoint> points;
        solid.surfaces(mScene.camera.eye, ray, 0, points);
        if (points.empty())
            return {};
        return {points[0], solid.colour(points[0], &ray)};
    }

private:
    PaintingScene mScene;

public:
    PaintingSolid solid;
};

Vector3d encoded(float r, float g, float b)
{
    return encodedFromLinear(Vector3d(r, g, b));
}

// As in painting_scenes.cpp.
const Vector3d paper = encoded(0.85f, 0.8f, 0.7f), blue = encoded(0.1f, 0.25f, 0.8f),
               red = encoded(0.8f, 0.08f, 0.05f), green = encoded(0.1f, 0.55f, 0.15f),
               yellow = encoded(0.95f, 0.75f, 0.1f);

bool near(const Vector3d &a, const Vector3d &b, double tolerance = 1e-6)
{
    return (a - b).cwiseAbs().maxCoeff() <= tolerance;
}

bool isRed(const Probe &probe)
{
    return probe.point && near(probe.colour, red);
}

ReferenceFrame frameOf(const PaintingScene &scene, int width = 160)
{
    ReferenceOptions options;
    options.width = width;
    options.height = width * 3 / 4;
    options.moment = scene.moment;
    return *referenceFrame(scene.painting, scene.camera, options, {});
}

/// Formulas of W3C Compositing 1, written once more.
double channel(BlendMode mode, double b, double s)
{
    const auto hard = [](double low, double high) {
        return high <= 0.5 ? 2 * low * high : 1 - 2 * (1 - low) * (1 - high);
    };
    switch (mode) {
    case BlendMode::Multiply:
        return b * s;
    case BlendMode::Screen:
        return 1 - (1 - b) * (1 - s);
    case BlendMode::Overlay:
        return hard(s, b);
    case BlendMode::HardLight:
        return hard(b, s);
    case BlendMode::Add:
        return std::min(1.0, b + s);
    case BlendMode::Darken:
        return b < s ? b : s;
    case BlendMode::Lighten:
        return b > s ? b : s;
    case BlendMode::ColourDodge:
        return b == 0 ? 0 : s == 1 ? 1 : std::min(1.0, b / (1 - s));
    case BlendMode::ColourBurn:
        return b == 1 ? 1 : s == 0 ? 0 : 1 - std::min(1.0, (1 - b) / s);
    case BlendMode::SoftLight:
        if (s <= 0.5)
            return b - (1 - 2 * s) * b * (1 - b);
        return b + (2 * s - 1) * ((b <= 0.25 ? ((16 * b - 12) * b + 4) * b : std::sqrt(b)) - b);
    case BlendMode::Difference:
        return std::abs(b - s);
    case BlendMode::Exclusion:
        return b + s - 2 * b * s;
    default:
        return s;
    }
}

} // namespace

class ReferenceFrameTest : public QObject
{
    Q_OBJECT
private slots:
    void scenesKeepTheInvariants();
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
    void mirroredHalvesAreMirrorImages();
    void hiddenLayersChangeNothing();
    void twoHundredStacksKeepApart();
    void masksFollowTheirFormulas();
    void strokeMasksCutOut();
    void blendsAsW3CSays_data();
    void blendsAsW3CSays();
    void sceneStackColoursAll();
    void looksAndMotion();
    void translucentSubstratesLetThrough();
    void meshesColourAndAreColoured();
    void backgroundAndAlpha();
    void namesTheLayersOfAPoint();
    void refusesAndCancels();
};

void ReferenceFrameTest::scenesKeepTheInvariants()
{
    std::set<std::string> names;
    for (const PaintingScene &scene : allPaintingScenes()) {
        const auto ok = checkPainting(scene.painting);
        QVERIFY2(ok.ok(), (scene.name + (ok ? "" : ok.error().message())).c_str());
        QVERIFY2(names.insert(scene.name).second, scene.name.c_str());
        const ReferenceFrame frame = frameOf(scene, 32);
        QVERIFY2(std::count(frame.stack.begin(), frame.stack.end(), -1) < 32 * 24 * 9 / 10,
                 scene.name.c_str());
    }
}

void ReferenceFrameTest::coloursWhereStrokesIntersect()
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

void ReferenceFrameTest::coloursWithTheCameraInsideAStroke()
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

void ReferenceFrameTest::aStrokeColoursAPointOnce()
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

void ReferenceFrameTest::strokesCompositeInDrawingOrder()
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

void ReferenceFrameTest::marksKeepTheirWidthFromAllSides_data()
{
    QTest::addColumn<int>("view");
    for (int view = 0; view < 7; ++view)
        QTest::addRow("%d", view) << view;
}

void ReferenceFrameTest::marksKeepTheirWidthFromAllSides()
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

void ReferenceFrameTest::bothEyesSeeTheSameMark_data()
{
    QTest::addColumn<bool>("bumpy");
    QTest::newRow("flat") << false;
    QTest::newRow("bumpy") << true;
}

void ReferenceFrameTest::bothEyesSeeTheSameMark()
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

void ReferenceFrameTest::marksHaveNoGapsOnBumps()
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

void ReferenceFrameTest::toleranceReachesSoFarAndNoFurther()
{
    const Prober prober(toleranceReach());
    for (double x = -0.75; x <= 0.75; x += 0.05)
        for (double y = -0.09; y <= 0.09; y += 0.03) {
            QVERIFY(isRed(prober.towards({x, 0.5 + y, 0})));
            QVERIFY(isRed(prober.towards({x, y, 0})));
            QVERIFY(near(prober.towards({x, -0.5 + y, 0}).colour, paper));
        }
}

void ReferenceFrameTest::viewToleranceIsADifferenceOfDepth()
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

void ReferenceFrameTest::mirroredHalvesAreMirrorImages()
{
    const ReferenceFrame frame = frameOf(mirroredElements());
    const int width = frame.colour.width, height = frame.colour.height;
    int different = 0, coloured = 0;
    std::set<Rgba> colours;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width / 2; ++x) {
            different += frame.colour.at(x, y) != frame.colour.at(width - 1 - x, y);
            coloured += frame.stack[std::size_t(y * width + x)] >= 0;
            colours.insert(frame.colour.at(x, y));
        }
    QVERIFY(coloured > 1000);
    QVERIFY(colours.size() >= 5); // background, two substrates, under two coats
    QVERIFY2(different <= coloured / 200, qPrintable(QString("%1 of %2").arg(different).arg(coloured)));
}

void ReferenceFrameTest::hiddenLayersChangeNothing()
{
    const ReferenceFrame with = frameOf(hiddenLayers()), without = frameOf(strokeOrder());
    QVERIFY(with.colour.pixels == without.colour.pixels);
    QVERIFY(with.stack == without.stack && with.element == without.element && with.depth == without.depth);
}

void ReferenceFrameTest::twoHundredStacksKeepApart()
{
    const PaintingScene scene = twoHundredStacks();
    const Prober prober(scene);
    for (int i = 0; i < 200; ++i) {
        const Vec3 centre(-0.95 + 0.1 * (i % 20), -0.65 + 0.14 * (i / 20), 0.03);
        const Probe probe = prober.towards(centre);
        QVERIFY(probe.point && probe.point->stack == i);
        QVERIFY(near(probe.colour, encoded(float(i % 20) / 20, float(i / 20) / 10, 0.5f)));
    }
}

void ReferenceFrameTest::masksFollowTheirFormulas()
{
    const auto share = [](const Probe &probe) { // of the coat
        return (probe.colour - paper).dot(blue - paper) / (blue - paper).squaredNorm();
    };
    const Prober linear(masked("linear")), spherical(masked("spherical")), two(masked("two")),
        noise(masked("noise")), texture(masked("texture"));
    int high = 0, low = 0;
    for (double x = -0.85; x <= 0.85; x += 0.05)
        for (double y = -0.55; y <= 0.55; y += 0.05) {
            const Vec3 p(x, y, 0);
            const double l = std::clamp(((x + 0.6) * 1.2 + (y + 0.2) * 0.4) / 1.6, 0.0, 1.0);
            QVERIFY(std::abs(share(linear.towards(p)) - (1 - l)) < 1e-6);
            const double t = std::min(1.0, std::hypot(x - 0.2, y - 0.1) / 0.5), s = t * t * (3 - 2 * t);
            QVERIFY(std::abs(share(spherical.towards(p)) - (1 - s)) < 1e-6);
            QVERIFY(std::abs(share(two.towards(p)) - s * (1 - l)) < 1e-6);
            const double n = share(noise.towards(p));
            QVERIFY(n > -1e-6 && n < 1 + 1e-6);
            ++(n > 0.5 ? high : low);
        }
    QVERIFY(high > 200 && low > 200); // noise is neither all nor nothing
    // A texture of 5 x 4 x 3 in a cube of 1.2: the plate cuts it half way up, in the middle of layer 1.
    const PaintingScene scene = masked("texture");
    const auto &values =
        *std::get<TextureMask>(scene.painting.stacks[0].appearance[1].properties.masks[0].shape).values;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 4; ++j) {
            const Vec3 cell(-0.6 + 1.2 * (i + 0.5) / 5, -0.6 + 1.2 * (j + 0.5) / 4, 0);
            const double expected = values[std::size_t((4 + j) * 5 + i)] / 255.0;
            QVERIFY(std::abs(share(texture.towards(cell)) - expected) < 1e-6);
        }
}

void ReferenceFrameTest::strokeMasksCutOut()
{
    const Prober inside(masked("stroke-inside")), outside(masked("stroke-outside"));
    int in = 0, out = 0;
    for (double x = -0.85; x <= 0.85; x += 0.05)
        for (double y = -0.55; y <= 0.55; y += 0.05) {
            const bool shown = near(inside.towards({x, y, 0}).colour, blue);
            QVERIFY(shown != near(outside.towards({x, y, 0}).colour, blue));
            const double middle = 0.3 * std::sin(7 * (x + 0.8) / 1.6); // of the wavy stroke
            if (std::abs(x) < 0.8 && std::abs(y - middle) < 0.1)
                QVERIFY(shown);
            if (std::abs(y - middle) > 0.35)
                QVERIFY(!shown);
            ++(shown ? in : out);
        }
    QVERIFY(in > 100 && out > 100);
}

void ReferenceFrameTest::blendsAsW3CSays_data()
{
    QTest::addColumn<int>("mode");
    QTest::addColumn<bool>("linear");
    for (int mode = 0; mode < blendModeCount; ++mode)
        for (const bool linear : {false, true})
            QTest::addRow("%s %s", std::string(blendModeName(BlendMode(mode))).c_str(),
                          linear ? "linear" : "encoded")
                << mode << linear;
}

void ReferenceFrameTest::blendsAsW3CSays()
{
    QFETCH(int, mode);
    QFETCH(bool, linear);
    const PaintingScene scene = blended(BlendMode(mode), linear ? BlendSpace::Linear : BlendSpace::Encoded);
    const Prober prober(scene);
    const bool separable = BlendMode(mode) < BlendMode::Hue;
    const auto lum = [](const Vector3d &c) { return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2]; };
    for (int column = 0; column < 10; ++column)
        for (int bar = 0; bar < 6; ++bar) {
            const double x = -0.9 + 0.2 * column, y = -0.6 + 0.24 * bar;
            const Probe plain = prober.towards({x, y + 0.12, 0}), blend = prober.towards({x, y, 0});
            const auto layers = prober.solid.coloursAt(*blend.point, nullptr);
            QCOMPARE(layers.size(), std::size_t(1));
            const Vector3d b = plain.colour, s = layers[0].source.colour / layers[0].source.alpha;
            const double alpha = 0.9 * (bar % 2 ? double(0.7f) : 1.0);
            QVERIFY(std::abs(layers[0].source.alpha * layers[0].opacity - alpha) < 1e-6);
            if (linear)
                QVERIFY(near(b, blend.point->colour.cast<double>()));
            else
                QVERIFY(near(b, encodedFromLinear(blend.point->colour.cast<double>())));
            if (separable) {
                for (int i = 0; i < 3; ++i) {
                    const double expected = (1 - alpha) * b[i] + alpha * channel(BlendMode(mode), b[i], s[i]);
                    QVERIFY(std::abs(blend.colour[i] - expected) < 1e-6);
                }
            } else { // what the four others promise of luminosity
                const Vector3d mixed = (blend.colour - (1 - alpha) * b) / alpha;
                const double kept = lum(BlendMode(mode) == BlendMode::Luminosity ? s : b);
                QVERIFY(std::abs(lum(mixed) - kept) < 1e-6);
            }
        }
}

void ReferenceFrameTest::sceneStackColoursAll()
{
    const Prober with(sceneStack()), without(intersectionFromOutside());
    std::set<int> stacks;
    for (double x = -0.9; x <= 0.9; x += 0.03)
        for (double y = 0; y <= 0.4; y += 0.03) {
            const Probe one = with.towards({x, y, 0.1}), other = without.towards({x, y, 0.1});
            if (!one.point || near(one.colour, other.colour))
                continue;
            stacks.insert(one.point->stack);
            for (int i = 0; i < 3; ++i) // screen comes after the stack's own layers
                QVERIFY(std::abs(one.colour[i] - (0.2 * other.colour[i] +
                                                  0.8 * (1 - (1 - other.colour[i]) * (1 - red[i])))) < 1e-6);
        }
    QCOMPARE(stacks, (std::set<int>{0, 1}));
}

void ReferenceFrameTest::looksAndMotion()
{
    QVERIFY(frameOf(dayAndNight(false)).colour.pixels == frameOf(sceneStack()).colour.pixels);
    QVERIFY(frameOf(dayAndNight(true)).colour.pixels != frameOf(sceneStack()).colour.pixels);

    const PaintingScene start = planeAndShadow(0), later = planeAndShadow(1.5);
    const Prober before(start), after(later);
    const Vec3 body(-0.6, 0.0, 0.46), shadow(-0.45, 0, 0);
    const double t = 0.75;
    Placement moved;
    moved.rotation = Eigen::AngleAxisd(0.4 * t, Vec3::UnitZ());
    moved.translation = t * Vec3(1.1, 0.2, 0);
    QVERIFY(near(before.towards(body).colour, red));
    QVERIFY(near(after.towards(moved.matrix() * body).colour, red));
    QVERIFY(!near(after.towards(body).colour, red));
    const auto onPlate = [](const Prober &prober, const Vec3 &p) { // from close above
        std::vector<SubstratePoint> points;
        prober.solid.surfaces(p + Vec3(0, 0, 0.1), {0, 0, -1}, 0, points);
        return prober.solid.colour(points.at(0), nullptr);
    };
    const Vector3d under = onPlate(before, shadow);
    QVERIFY(!near(under, paper));
    QVERIFY(near(onPlate(after, moved.matrix() * shadow), under)); // the shadow goes with the plane
    QVERIFY(near(onPlate(after, shadow), paper));
    QVERIFY(near(before.towards({0.6, 0.4, 0.32}).colour, paper));
    PaintingScene round = planeAndShadow(5.5); // looped after 4 seconds
    QVERIFY(frameOf(round).colour.pixels == frameOf(later).colour.pixels);
}

void ReferenceFrameTest::translucentSubstratesLetThrough()
{
    const PaintingScene scene = translucentSubstrates();
    const Prober prober(scene);
    std::vector<SubstratePoint> points;
    // Through the red stroke where the blue one is behind it, then the plate.
    const Vec3 target(0.3, 0.12, 0.6), ray = target - scene.camera.eye;
    prober.solid.surfaces(scene.camera.eye, ray, 0, points);
    QVERIFY(points.size() >= 2);
    QVERIFY(points.back().opacity == 1 && points.front().opacity == 0.5);
    for (std::size_t i = 1; i < points.size(); ++i) {
        QVERIFY(points[i].depth >= points[i - 1].depth);
        for (std::size_t j = 0; j < i; ++j)
            QVERIFY(points[i].element != points[j].element); // each shows its first skin only
    }
    // The frame at the red stroke's top, where nothing but the background is behind it.
    ReferenceOptions options;
    options.width = 400;
    options.height = 300;
    options.transparentBackground = true;
    const ReferenceFrame frame = *referenceFrame(scene.painting, scene.camera, options, {});
    int halves = 0;
    for (std::size_t i = 0; i < frame.depth.size(); ++i)
        halves += frame.colour.pixels[4 * i + 3] == 128;
    QVERIFY(halves > 100);
}

void ReferenceFrameTest::meshesColourAndAreColoured()
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

void ReferenceFrameTest::backgroundAndAlpha()
{
    PaintingScene scene = selfOverlap();
    scene.painting.background = {0.2f, 0.4f, 0.6f};
    ReferenceOptions options;
    options.width = 64;
    options.height = 48;
    options.samplesPerAxis = 4;
    const ReferenceFrame solid = *referenceFrame(scene.painting, scene.camera, options, {});
    const Vector3d back = 255 * encoded(0.2f, 0.4f, 0.6f);
    QCOMPARE(solid.colour.at(0, 0),
             (Rgba{std::uint8_t(std::lround(back[0])), std::uint8_t(std::lround(back[1])),
                   std::uint8_t(std::lround(back[2])), 255}));
    QVERIFY(std::isinf(solid.depth[0]) && solid.stack[0] == -1 && solid.element[0] == -1);
    options.transparentBackground = true;
    const ReferenceFrame clear = *referenceFrame(scene.painting, scene.camera, options, {});
    std::set<int> alphas;
    for (std::size_t i = 3; i < clear.colour.pixels.size(); i += 4)
        alphas.insert(clear.colour.pixels[i]);
    QVERIFY(alphas.contains(0) && alphas.contains(255) && alphas.size() >= 3); // soft edges
    const std::size_t middle = std::size_t(24 * 64 + 10);
    QVERIFY(std::abs(clear.depth[middle] - 2.6) < 1e-5); // along the view axis, not the ray
}

void ReferenceFrameTest::namesTheLayersOfAPoint()
{
    const PaintingScene scene = sceneStack();
    const Prober prober(scene);
    for (double x = -0.5; x <= 0.5; x += 0.02) {
        const Probe probe = prober.towards({x, 0.1, 0.2});
        if (!probe.point || probe.point->stack != 0)
            continue;
        const auto layers = prober.solid.coloursAt(*probe.point, nullptr);
        if (layers.size() < 2)
            continue;
        QCOMPARE(layers[0].layer, scene.painting.sceneStack.appearance[0].id); // topmost first
        QCOMPARE(layers[1].layer, scene.painting.stacks[0].appearance[0].id);
        QCOMPARE(layers[1].elements.size(), std::size_t(1));
        QVERIFY(near(layers[0].result, probe.colour));
        QVERIFY(near(layers[1].result, blue));
        return;
    }
    QFAIL("no point is coloured by both");
}

void ReferenceFrameTest::refusesAndCancels()
{
    const PaintingScene scene = strokeOrder();
    ReferenceOptions options;
    options.width = 0;
    QCOMPARE(referenceFrame(scene.painting, scene.camera, options, {}).error().code,
             ErrorCode::InvalidArgument);
    options.width = 64;
    options.samplesPerAxis = 9;
    QCOMPARE(referenceFrame(scene.painting, scene.camera, options, {}).error().code,
             ErrorCode::InvalidArgument);
    options.samplesPerAxis = 1;
    FrameCamera camera = scene.camera;
    camera.eye.x() = std::nan("");
    QCOMPARE(referenceFrame(scene.painting, camera, options, {}).error().code, ErrorCode::InvalidArgument);
    options.moment.look = LookId{77};
    QCOMPARE(referenceFrame(scene.painting, scene.camera, options, {}).error().code,
             ErrorCode::InvalidArgument);
    options.moment.look.reset();
    const std::atomic<bool> cancelled{true};
    QVERIFY(referenceFrame(scene.painting, scene.camera, options, JobControl(&cancelled, {}))
                .error()
                .isCancelled());
    const ReferenceFrame nothing = *referenceFrame(Painting(), scene.camera, options, {});
    QCOMPARE(nothing.colour.at(3, 3), (Rgba{255, 255, 255, 255}));
}

QTEST_APPLESS_MAIN(ReferenceFrameTest)
#include "reference_frame_test.moc"
