#include "painting/blend/blend.h"

#include "base/random.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace ductus;
using Eigen::Vector3d;

namespace {

// The formulas once more, as the W3C writes them: sections 10.1 and 10.2 of Compositing and Blending Level 1.

double w3cMultiply(double cb, double cs)
{
    return cb * cs;
}

double w3cScreen(double cb, double cs)
{
    return 1 - (1 - cb) * (1 - cs);
}

double w3cHardLight(double cb, double cs)
{
    if (cs <= 0.5)
        return w3cMultiply(cb, 2 * cs);
    return w3cScreen(cb, 2 * cs - 1);
}

double w3cSoftLight(double cb, double cs)
{
    const double d = cb <= 0.25 ? ((16 * cb - 12) * cb + 4) * cb : std::sqrt(cb);
    if (cs <= 0.5)
        return cb - (1 - 2 * cs) * cb * (1 - cb);
    return cb + (2 * cs - 1) * (d - cb);
}

double w3cDodge(double cb, double cs)
{
    if (cb == 0)
        return 0;
    if (cs == 1)
        return 1;
    return std::min(1.0, cb / (1 - cs));
}

double w3cBurn(double cb, double cs)
{
    if (cb == 1)
        return 1;
    if (cs == 0)
        return 0;
    return 1 - std::min(1.0, (1 - cb) / cs);
}

double w3cSeparable(BlendMode mode, double cb, double cs)
{
    switch (mode) {
    case BlendMode::Normal:
        return cs;
    case BlendMode::Multiply:
        return w3cMultiply(cb, cs);
    case BlendMode::Screen:
        return w3cScreen(cb, cs);
    case BlendMode::Overlay:
        return w3cHardLight(cs, cb);
    case BlendMode::Add:
        return cb + cs > 1 ? 1 : cb + cs;
    case BlendMode::Darken:
        return cb < cs ? cb : cs;
    case BlendMode::Lighten:
        return cb > cs ? cb : cs;
    case BlendMode::ColourDodge:
        return w3cDodge(cb, cs);
    case BlendMode::ColourBurn:
        return w3cBurn(cb, cs);
    case BlendMode::HardLight:
        return w3cHardLight(cb, cs);
    case BlendMode::SoftLight:
        return w3cSoftLight(cb, cs);
    case BlendMode::Difference:
        return cb > cs ? cb - cs : cs - cb;
    case BlendMode::Exclusion:
        return cb + cs - 2 * cb * cs;
    default:
        return std::nan("");
    }
}

double w3cLum(const Vector3d &c)
{
    return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2];
}

double w3cSat(const Vector3d &c)
{
    return std::max({c[0], c[1], c[2]}) - std::min({c[0], c[1], c[2]});
}

Vector3d w3cClipColor(Vector3d c)
{
    const double l = w3cLum(c), n = c.minCoeff(), x = c.maxCoeff();
    for (int i = 0; i < 3; ++i) {
        if (n < 0)
            c[i] = l + (c[i] - l) * l / (l - n);
    }
    for (int i = 0; i < 3; ++i) {
        if (x > 1)
            c[i] = l + (c[i] - l) * (1 - l) / (x - l);
    }
    return c;
}

Vector3d w3cSetLum(const Vector3d &c, double l)
{
    return w3cClipColor(c.array() + (l - w3cLum(c)));
}

// By sorted channels, as the text does.
Vector3d w3cSetSat(const Vector3d &c, double s)
{
    int order[3] = {0, 1, 2};
    std::sort(order, order + 3, [&](int a, int b) { return c[a] < c[b]; });
    Vector3d result = Vector3d::Zero();
    if (c[order[2]] > c[order[0]]) {
        result[order[1]] = (c[order[1]] - c[order[0]]) * s / (c[order[2]] - c[order[0]]);
        result[order[2]] = s;
    }
    return result;
}

Vector3d w3cBlend(BlendMode mode, const Vector3d &cb, const Vector3d &cs)
{
    switch (mode) {
    case BlendMode::Hue:
        return w3cSetLum(w3cSetSat(cs, w3cSat(cb)), w3cLum(cb));
    case BlendMode::Saturation:
        return w3cSetLum(w3cSetSat(cb, w3cSat(cs)), w3cLum(cb));
    case BlendMode::Colour:
        return w3cSetLum(cs, w3cLum(cb));
    case BlendMode::Luminosity:
        return w3cSetLum(cb, w3cLum(cs));
    default:
        return {w3cSeparable(mode, cb[0], cs[0]), w3cSeparable(mode, cb[1], cs[1]),
                w3cSeparable(mode, cb[2], cs[2])};
    }
}

bool near(const Vector3d &a, const Vector3d &b, double tolerance = 1e-9)
{
    return (a - b).cwiseAbs().maxCoeff() <= tolerance;
}

} // namespace

class BlendTest : public QObject
{
    Q_OBJECT
private slots:
    void namesComeBack();
    void equalsTheText_data();
    void equalsTheText();
    void knownNumbers_data();
    void knownNumbers();
    void opacityMixesStraightly();
    void mixesPremultipliedLayers();
    void strokesOverStrokes();
    void encodesAsTheStandard();
    void spacesDiffer();
};

void BlendTest::namesComeBack()
{
    for (int i = 0; i < blendModeCount; ++i)
        QCOMPARE(blendModeOf(blendModeName(BlendMode(i))), std::optional(BlendMode(i)));
    QVERIFY(!blendModeOf("dissolve"));
    QVERIFY(!blendModeOf(""));
    QCOMPARE(blendModeName(BlendMode::Luminosity), std::string_view("luminosity"));
}

void BlendTest::equalsTheText_data()
{
    QTest::addColumn<int>("mode");
    for (int i = 0; i < blendModeCount; ++i)
        QTest::newRow(std::string(blendModeName(BlendMode(i))).c_str()) << i;
}

void BlendTest::equalsTheText()
{
    QFETCH(int, mode);
    // Corners, pivots and their neighbours in every combination, then random colours.
    const double special[] = {0, 1e-9, 0.25, 0.25 + 1e-9, 0.5, 0.5 + 1e-9, 0.75, 1 - 1e-9, 1};
    for (const double b : special)
        for (const double s : special)
            for (const double t : special) {
                const Vector3d backdrop(b, t, s), source(s, b, t);
                const Vector3d mixed = blendFunction(BlendMode(mode), backdrop, source);
                QVERIFY(near(mixed, w3cBlend(BlendMode(mode), backdrop, source), 1e-6));
                QVERIFY(mixed.minCoeff() >= 0 && mixed.maxCoeff() <= 1);
            }
    Random random(7);
    for (int run = 0; run < 20000; ++run) {
        const auto colour = [&] { return Vector3d(random.uniform(), random.uniform(), random.uniform()); };
        const Vector3d backdrop = colour(), source = colour();
        const Vector3d mixed = blendFunction(BlendMode(mode), backdrop, source);
        QVERIFY(near(mixed, w3cBlend(BlendMode(mode), backdrop, source)));
        QVERIFY(mixed.minCoeff() >= 0 && mixed.maxCoeff() <= 1);
    }
}

void BlendTest::knownNumbers_data()
{
    QTest::addColumn<int>("mode");
    QTest::addColumn<double>("result"); // of backdrop 0.6 and source 0.3, worked out by hand
    QTest::newRow("normal") << int(BlendMode::Normal) << 0.3;
    QTest::newRow("multiply") << int(BlendMode::Multiply) << 0.18;
    QTest::newRow("screen") << int(BlendMode::Screen) << 0.72;
    QTest::newRow("overlay") << int(BlendMode::Overlay) << 0.44;
    QTest::newRow("add") << int(BlendMode::Add) << 0.9;
    QTest::newRow("darken") << int(BlendMode::Darken) << 0.3;
    QTest::newRow("lighten") << int(BlendMode::Lighten) << 0.6;
    QTest::newRow("dodge") << int(BlendMode::ColourDodge) << 0.6 / 0.7;
    QTest::newRow("burn") << int(BlendMode::ColourBurn) << 0.0;
    QTest::newRow("hard light") << int(BlendMode::HardLight) << 0.36;
    QTest::newRow("soft light") << int(BlendMode::SoftLight) << 0.504;
    QTest::newRow("difference") << int(BlendMode::Difference) << 0.3;
    QTest::newRow("exclusion") << int(BlendMode::Exclusion) << 0.54;
    QTest::newRow("luminosity") << int(BlendMode::Luminosity) << 0.3;
    QTest::newRow("colour") << int(BlendMode::Colour) << 0.6;
}

void BlendTest::knownNumbers()
{
    QFETCH(int, mode);
    QFETCH(double, result);
    const Vector3d mixed = blendFunction(BlendMode(mode), Vector3d::Constant(0.6), Vector3d::Constant(0.3));
    QVERIFY2(near(mixed, Vector3d::Constant(result), 1e-12), std::to_string(mixed[0]).c_str());
}

void BlendTest::opacityMixesStraightly()
{
    const Vector3d backdrop(0.2, 0.5, 0.9);
    const PremultipliedColour source{Vector3d(0.8, 0.1, 0.4), 1};
    for (int i = 0; i < blendModeCount; ++i) {
        const BlendMode mode = BlendMode(i);
        QVERIFY(blendOnOpaque(mode, backdrop, source, 0) == backdrop);
        const Vector3d full = blendOnOpaque(mode, backdrop, source, 1);
        QVERIFY(near(full, blendFunction(mode, backdrop, source.colour)));
        QVERIFY(near(blendOnOpaque(mode, backdrop, source, 0.25), 0.75 * backdrop + 0.25 * full));
        QVERIFY(blendOnOpaque(mode, backdrop, {}, 1) == backdrop); // no stroke here
    }
}

void BlendTest::mixesPremultipliedLayers()
{
    // A layer half covered in red: the formula sees red, not dark red.
    const Vector3d backdrop(0.5, 0.5, 0.5);
    const PremultipliedColour red{Vector3d(0.5, 0, 0), 0.5};
    QVERIFY(near(blendOnOpaque(BlendMode::Normal, backdrop, red, 1), Vector3d(0.75, 0.25, 0.25)));
    QVERIFY(near(blendOnOpaque(BlendMode::Multiply, backdrop, red, 1), Vector3d(0.5, 0.25, 0.25)));
    QVERIFY(near(blendOnOpaque(BlendMode::Difference, backdrop, red, 0.5), Vector3d(0.5, 0.5, 0.5)));
}

void BlendTest::strokesOverStrokes()
{
    const PremultipliedColour half{Vector3d(0.5, 0, 0), 0.5};
    const PremultipliedColour solid{Vector3d(0, 0, 1), 1};
    const PremultipliedColour mixed = over(half, solid);
    QVERIFY(near(mixed.colour, Vector3d(0.5, 0, 0.5)));
    QCOMPARE(mixed.alpha, 1.0);
    const PremultipliedColour twice = over(half, half);
    QCOMPARE(twice.alpha, 0.75);
    QVERIFY(near(twice.colour, Vector3d(0.75, 0, 0)));
}

void BlendTest::encodesAsTheStandard()
{
    // Linear 0.5 is 8-bit 188; encoded 0.5 is linear 0.2140.
    QCOMPARE(std::lround(255 * encodedFromLinear(Vector3d::Constant(0.5))[0]), 188L);
    QVERIFY(std::abs(linearFromEncoded(Vector3d::Constant(0.5))[1] - 0.21404114) < 1e-8);
    for (int i = 0; i <= 1000; ++i) {
        const Vector3d value = Vector3d::Constant(i / 1000.0);
        QVERIFY(near(linearFromEncoded(encodedFromLinear(value)), value, 1e-6));
    }
}

void BlendTest::spacesDiffer()
{
    // Half a layer of white on black: middle grey to a painter, half the light to a physicist.
    const auto mixed = [](BlendSpace space) {
        const Vector3d white = toBlendSpace(space, Vector3d::Ones());
        const Vector3d black = toBlendSpace(space, Vector3d::Zero());
        return fromBlendSpace(space, blendOnOpaque(BlendMode::Normal, black, {white, 1}, 0.5));
    };
    QVERIFY(near(mixed(BlendSpace::Encoded), Vector3d::Constant(0.21404114), 1e-7));
    QVERIFY(near(mixed(BlendSpace::Linear), Vector3d::Constant(0.5)));
}

QTEST_APPLESS_MAIN(BlendTest)
#include "blend_test.moc"
