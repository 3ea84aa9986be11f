// What colour the reference gives a point: masks, blend modes, the scene stack, translucent shapes.
#include "painting/reference/reference_frame.h"

#include "painting/coverage/mask_value.h"
#include "support/painting_prober.h"

#include <QtTest>
#include <set>

using namespace ductus;
using Eigen::Vector3d;

namespace {

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

class ReferenceBlendTest : public QObject
{
    Q_OBJECT
private slots:
    void masksFollowTheirFormulas();
    void strokeMasksCutOut();
    void blendsAsW3CSays_data();
    void blendsAsW3CSays();
    void sceneStackColoursAll();
    void translucentSubstratesLetThrough();
};

void ReferenceBlendTest::masksFollowTheirFormulas()
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

void ReferenceBlendTest::strokeMasksCutOut()
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

void ReferenceBlendTest::blendsAsW3CSays_data()
{
    QTest::addColumn<int>("mode");
    QTest::addColumn<bool>("linear");
    for (int mode = 0; mode < blendModeCount; ++mode)
        for (const bool linear : {false, true})
            QTest::addRow("%s %s", std::string(blendModeName(BlendMode(mode))).c_str(),
                          linear ? "linear" : "encoded")
                << mode << linear;
}

void ReferenceBlendTest::blendsAsW3CSays()
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

void ReferenceBlendTest::sceneStackColoursAll()
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

void ReferenceBlendTest::translucentSubstratesLetThrough()
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

QTEST_APPLESS_MAIN(ReferenceBlendTest)
#include "reference_blend_test.moc"
