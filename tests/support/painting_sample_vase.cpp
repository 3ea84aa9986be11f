// One vase in three glazes: the shape is painted once, ornament and colour are layers (looks as colourways).
#include "support/painting_brush.h"
#include "support/painting_samples.h"

#include <cmath>
#include <numbers>

namespace ductus {

namespace {

using Point = PaintingBrush::Point;

constexpr float pi = std::numbers::pi_v<float>;
constexpr float top = 2.62f;

Point c(unsigned rgb)
{
    return PaintingBrush::colour(rgb);
}

// Foot, belly, neck, lip.
float radiusAt(float y)
{
    const float t = y / top;
    const float belly = 0.84f * std::exp(-9 * (t - 0.44f) * (t - 0.44f));
    const float lip = 0.2f * std::exp(-160 * (t - 1.0f) * (t - 1.0f));
    const float foot = 0.12f * std::exp(-300 * t * t);
    return 0.3f + belly + lip + foot;
}

Point onVase(float angle, float y, float out = 0)
{
    const float radius = radiusAt(y) + out;
    return {radius * std::sin(angle), y, radius * std::cos(angle)};
}

std::vector<Point> ring(float y, float out = 0, float wave = 0, int waves = 0)
{
    std::vector<Point> points;
    const int steps = 44;
    for (int k = 0; k <= steps; ++k) {
        const float angle = 2 * pi * float(k) / float(steps);
        points.push_back(onVase(angle, y + wave * std::sin(float(waves) * angle), out));
    }
    return points;
}

void paintRoom(PaintingBrush &b, LayerId wall, LayerId table)
{
    for (int k = 0; k < 22; ++k) {
        const float x = -4.9f + 0.46f * float(k);
        b.shaded(wall, StrokeSection::Cube,
                 {Point(x, -0.6f, -2.2f), Point(x, 1.6f, -2.2f), Point(x, 4.6f, -2.2f)}, 0.235f,
                 b.varied(c(0xd8cbb6), 0.03f), b.varied(c(0xb9b4a8), 0.03f), Point::UnitZ());
    }
    b.boards(table, {-5, -0.13f, -1.9f}, {5, -0.13f, 2.6f}, true, 0.26f, c(0x8a5a3a), 0.1f);
}

// A twig with leaves that goes around the belly.
void paintTwig(PaintingBrush &b, LayerId leaves, float y, float turn)
{
    const int count = 7;
    for (int k = 0; k < count; ++k) {
        const float middle = turn + 2 * pi * float(k) / count, step = pi / count;
        std::vector<Point> stem;
        for (int i = -6; i <= 6; ++i)
            stem.push_back(
                onVase(middle + step * float(i) / 6, y + 0.13f * std::sin(pi * float(i) / 6), 0.01f));
        b.stroke(leaves, StrokeSection::Round, stem, {0.022f}, c(0x2c4f8f));
        for (int i = -2; i <= 2; ++i) {
            const float angle = middle + step * float(i) / 2.5f, side = i % 2 == 0 ? 1.f : -1.f;
            const float foot = y + 0.13f * std::sin(pi * float(i) / 2.5f);
            b.stroke(leaves, StrokeSection::Round,
                     {onVase(angle, foot), onVase(angle + 0.07f, foot + 0.11f * side, 0.01f),
                      onVase(angle + 0.11f, foot + 0.27f * side)},
                     {0.015f, 0.062f, 0.004f}, c(0x2c4f8f));
        }
        const Point flower = onVase(middle + step, y, 0.0f); // between two twigs
        for (int petal = 0; petal < 5; ++petal) {
            const float a = 2 * pi * float(petal) / 5;
            b.stroke(leaves, StrokeSection::Round,
                     {flower, onVase(middle + step + 0.09f * std::cos(a), y + 0.1f * std::sin(a))},
                     {0.02f, 0.05f}, c(0x2c4f8f));
        }
    }
}

} // namespace

Painting vaseInThreeGlazes()
{
    PaintingBrush b(53);
    b.painting.background = c(0xcfc4b2);
    const LayerId wall = b.stack("Wall"), table = b.stack("Table"), vase = b.stack("Vase"),
                  fruit = b.stack("Fruit");
    paintRoom(b, wall, table);
    // Rings as far apart along the outline, so that it is smooth where it is flat, too.
    for (float y = 0; y <= top;) {
        b.stroke(vase, StrokeSection::Round, ring(y, -0.07f), {0.075f}, b.varied(c(0xc98a63), 0.02f));
        const float slope = (radiusAt(y + 0.01f) - radiusAt(y)) / 0.01f;
        y += 0.055f / std::sqrt(1 + slope * slope);
    }
    const std::pair<Point, unsigned> fruits[] = {{{1.6f, 0.27f, 0.75f}, 0xd9503f},
                                                 {{2.12f, 0.25f, 0.15f}, 0xe3a23a},
                                                 {{1.72f, 0.2f, 1.35f}, 0x8fae4f}};
    for (const auto &[place, colour] : fruits) {
        b.stroke(fruit, StrokeSection::Round, {place - Point(0, 0.1f, 0), place, place + Point(0, 0.1f, 0)},
                 {0.24f, 0.3f, 0.24f}, c(colour));
        b.stroke(fruit, StrokeSection::Round,
                 {place + Point(0, 0.32f, 0), place + Point(0.03f, 0.42f, 0), place + Point(0.08f, 0.5f, 0)},
                 {0.02f, 0.018f, 0.022f}, c(0x5b4636));
    }

    // The shape is done. Every layer below has one colour, which a look can replace.
    const LayerId glaze = b.layer(vase, "Glaze");
    b.everything(glaze, c(0xffffff));
    const LayerId bands = b.layer(vase, "Bands", BlendMode::Normal, 1, 0.05);
    for (const auto &[y, half] : std::initializer_list<std::pair<float, float>>{
             {0.16f, 0.05f}, {0.34f, 0.025f}, {1.86f, 0.05f}, {2.02f, 0.025f}, {2.5f, 0.05f}})
        b.stroke(bands, StrokeSection::Round, ring(y), {half}, c(0x2c4f8f));
    const LayerId waves = b.layer(vase, "Waves", BlendMode::Normal, 1, 0.05);
    for (const float y : {0.5f, 0.6f})
        b.stroke(waves, StrokeSection::Round, ring(y, 0, 0.055f, 12), {0.024f}, c(0x2c4f8f));
    b.stroke(waves, StrokeSection::Round, ring(2.25f, 0, 0.06f, 9), {0.03f}, c(0x2c4f8f));
    const LayerId twigs = b.layer(vase, "Twigs", BlendMode::Normal, 1, 0.05);
    paintTwig(b, twigs, 1.17f, 0.35f);
    const LayerId shade = b.layer(vase, "Shade", BlendMode::Multiply, 0.62, 0.3);
    for (float y = 0.05f; y < top; y += 0.12f)
        b.stroke(shade, StrokeSection::Round,
                 {onVase(0.85f, y, 0.1f), onVase(1.5f, y, 0.1f), onVase(2.2f, y, 0.1f)}, {0.02f, 0.34f},
                 c(0x8d7f9c));
    const LayerId shine = b.layer(vase, "Shine", BlendMode::Screen, 0.75, 0.1);
    std::vector<Point> gleam;
    for (float y = 0.7f; y < 1.75f; y += 0.15f)
        gleam.push_back(onVase(-0.62f, y));
    b.stroke(shine, StrokeSection::Round, gleam, {0.01f, 0.05f, 0.08f, 0.09f, 0.08f, 0.05f, 0.03f, 0.01f},
             c(0xfff6e6));
    b.stroke(shine, StrokeSection::Round, {onVase(-0.62f, 2.1f), onVase(-0.62f, 2.42f)}, {0.04f, 0.02f},
             c(0xfff6e6));
    const LayerId fruitShade = b.layer(fruit, "Shade on the fruit", BlendMode::Multiply, 0.6);
    b.copies(fruit, fruitShade, Vec3(0.16, -0.14, -0.02), 0.98);
    b.tint(fruitShade, 0x86709a);
    const LayerId fruitShine = b.layer(fruit, "Light on the fruit", BlendMode::Screen, 0.6, 0.05);
    for (const auto &[place, colour] : fruits)
        b.dab(fruitShine, place + Point(-0.15f, 0.16f, 0.2f), 0.07f, c(0xfff6e6), 0);
    const LayerId cast = b.layer(table, "Shadows on the table", BlendMode::Multiply, 0.6, 0.1);
    b.stroke(cast, StrokeSection::Round,
             {Point(0.2f, -0.1f, -0.1f), Point(1.5f, -0.1f, -0.7f), Point(2.9f, -0.1f, -1.3f)},
             {0.5f, 0.62f, 0.3f}, c(0x6a5a72));
    for (const auto &[place, colour] : fruits)
        b.stroke(cast, StrokeSection::Round,
                 {Point(place.x(), -0.1f, place.z()), Point(place.x() + 0.5f, -0.1f, place.z() - 0.25f)},
                 {0.27f, 0.2f}, c(0x6a5a72));
    const LayerId lamp = b.layer(wall, "Light from the left", BlendMode::Screen, 0.5);
    b.everything(lamp, c(0xffdfae));
    b.at(lamp).properties.masks = {
        {true, false,
         GradientMask{
             GradientMask::Shape::Spherical, {-2.6, 2.6, -2.2}, {1.6, 2.6, -2.2}, 1, 0, MaskEasing::Smooth}}};

    const auto colourway = [&](unsigned ground, unsigned band, unsigned wave, unsigned twig,
                               const char *name) {
        b.tint(glaze, ground);
        b.tint(bands, band);
        b.tint(waves, wave);
        b.tint(twigs, twig);
        b.keepLook(name);
    };
    colourway(0xc8764e, 0x3a2a28, 0x3a2a28, 0x4a2f2a, "Terracotta");
    colourway(0x9cc0a0, 0x4f7a64, 0xe6efd8, 0x3f6a58, "Celadon");
    colourway(0xf1f0ea, 0x2c4f9f, 0x4f78c4, 0x2c4f9f, "Blue and white");
    b.camera({-0.4, 2.1, 7.4}, {0.35, 1.22, 0}, 31);
    return b.painting;
}

} // namespace ductus
