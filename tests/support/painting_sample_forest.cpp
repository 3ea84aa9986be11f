// A path between trees, in neutral paint; light and weather are layers (Fig. V.11).
#include "support/painting_brush.h"
#include "support/painting_samples.h"

#include <cmath>

namespace ductus {

namespace {

using Point = PaintingBrush::Point;

float pathMiddle(float z)
{
    return 0.9f * std::sin(0.42f * z + 0.5f) + 0.06f * z;
}

void paintGround(PaintingBrush &b, LayerId ground)
{
    const Point grass = PaintingBrush::colour(0x6f9a4f), far = PaintingBrush::colour(0x8fb38a);
    for (float z = 4.5f; z > -13; z -= 0.42f) {
        const float t = std::min(1.f, std::max(0.f, -z / 13));
        std::vector<Point> points;
        for (float x = -9; x <= 9; x += 1.5f)
            points.push_back(
                {x, -0.12f + 0.05f * std::sin(1.3f * x + z), z + 0.1f * float(b.random.normal())});
        b.stroke(ground, StrokeSection::Ellipse, points, {0.36f}, b.varied((1 - t) * grass + t * far, 0.1f));
    }
    for (int i = 0; i < 70; ++i) { // tufts
        const float z = float(b.random.uniform(-7, 4)), side = b.random.index(2) ? 1.f : -1.f;
        const Point foot(pathMiddle(z) + side * float(b.random.uniform(0.75, 4)), -0.05f, z);
        const Point tip =
            foot + Point(0.1f * float(b.random.normal()), float(b.random.uniform(0.15, 0.34)), 0);
        b.stroke(ground, StrokeSection::Round, {foot, 0.5f * (foot + tip) + Point(0.02f, 0, 0), tip},
                 {0.05f, 0.04f, 0.004f}, b.varied(PaintingBrush::colour(0x7fae55), 0.2f));
    }
}

void paintPath(PaintingBrush &b, LayerId path)
{
    for (int lane = -2; lane <= 2; ++lane) {
        std::vector<Point> points;
        std::vector<float> widths;
        for (float z = 5; z > -12; z -= 0.5f) {
            points.push_back({pathMiddle(z) + 0.24f * float(lane), 0.0f + 0.012f * float(lane * lane), z});
            widths.push_back(0.17f + 0.02f * std::sin(3 * z + float(lane)));
        }
        b.stroke(path, StrokeSection::Ellipse, points, widths,
                 b.varied(PaintingBrush::colour(0xc9a878), 0.07f));
    }
    for (int i = 0; i < 26; ++i) { // stones along it
        const float z = float(b.random.uniform(-6, 4)), side = b.random.index(2) ? 1.f : -1.f;
        b.dab(path, {pathMiddle(z) + side * float(b.random.uniform(0.62, 0.8)), 0.0f, z},
              float(b.random.uniform(0.05, 0.13)), b.varied(PaintingBrush::colour(0xa9a49a), 0.15f), 0.4f);
    }
}

void paintTree(PaintingBrush &b, LayerId trunks, LayerId leaves, const Point &foot, float height,
               unsigned green)
{
    const float lean = 0.12f * float(b.random.normal());
    const Point top = foot + Point(lean * height, 0.72f * height, 0);
    const Point bark = b.varied(PaintingBrush::colour(0x6b4e3d), 0.15f);
    b.stroke(trunks, StrokeSection::Round,
             {foot - Point(0, 0.15f, 0), foot + Point(0.02f, 0.3f * height, 0),
              0.5f * (foot + top) + Point(0, 0.1f * height, 0), top},
             {0.075f * height, 0.05f * height, 0.04f * height, 0.02f * height}, bark);
    for (int i = 0; i < 3; ++i) {
        const float turn = float(b.random.uniform(0, 6.28));
        const Point from = foot + (0.5f + 0.12f * float(i)) * (top - foot);
        const Point to = from + 0.2f * height * Point(std::cos(turn), 0.7f, 0.6f * std::sin(turn));
        b.stroke(trunks, StrokeSection::Round, {from, 0.5f * (from + to), to},
                 {0.024f * height, 0.016f * height, 0.006f * height}, bark);
    }
    const int dabs = 13;
    for (int i = 0; i < dabs; ++i) {
        const float turn = 2.4f * float(i), up = float(i) / float(dabs);
        const float out = 0.27f * height * std::sqrt(1 - up) * float(b.random.uniform(0.75, 1.1));
        b.dab(leaves,
              top + Point(out * std::cos(turn), (up * 0.5f - 0.16f) * height, 0.8f * out * std::sin(turn)),
              height * float(b.random.uniform(0.12, 0.175)), b.varied(PaintingBrush::colour(green), 0.16f));
    }
}

void paintSky(PaintingBrush &b, LayerId sky)
{
    const Point low = PaintingBrush::colour(0xdcebf0), high = PaintingBrush::colour(0x8fc0dd);
    for (int i = 0; i < 13; ++i) {
        const float y = -1.5f + 1.15f * float(i), t = float(i) / 12;
        b.stroke(sky, StrokeSection::Ellipse,
                 {Point(-24, y, -16), Point(0, y + 0.3f, -17), Point(24, y, -16)}, {0.85f},
                 b.varied((1 - t) * low + t * high, 0.02f), Point::UnitZ());
    }
    for (int i = 0; i < 16; ++i) { // hills far away
        const float x = -15 + 2 * float(i);
        b.dab(sky, {x, 0.2f + 0.5f * std::sin(1.7f * x), -14}, float(b.random.uniform(1.3, 2.2)),
              b.varied(PaintingBrush::colour(0x9fbfb2), 0.05f), 0.3f);
    }
}

Mask gradient(const Vec3 &start, const Vec3 &end, double from, double to)
{
    return {true, false, GradientMask{GradientMask::Shape::Linear, start, end, from, to, MaskEasing::Smooth}};
}

} // namespace

Painting forestPath()
{
    PaintingBrush b(11);
    b.painting.background = PaintingBrush::colour(0xcfe3ea);
    const LayerId sky = b.stack("Sky"), ground = b.stack("Ground"), path = b.stack("Path"),
                  trunks = b.stack("Trunks"), leaves = b.stack("Leaves");
    paintSky(b, sky);
    paintGround(b, ground);
    paintPath(b, path);
    const std::pair<Point, float> trees[] = {
        {{-2.6f, 0, 1.2f}, 3.6f},  {{2.7f, 0, 0.2f}, 4.1f},   {{-3.3f, 0, -2.2f}, 4.2f},
        {{3.5f, 0, -3.1f}, 3.7f},  {{-1.9f, 0, -5.2f}, 3.4f}, {{2.4f, 0, -6.3f}, 3.8f},
        {{-4.9f, 0, -5.4f}, 4.4f}, {{5.4f, 0, -6.2f}, 4.4f},  {{-3.4f, 0, -8.6f}, 3.6f},
        {{0.9f, 0, -9.6f}, 3.2f},  {{-6.2f, 0, -1.2f}, 4.3f}, {{5.9f, 0, -1.6f}, 4.0f}};
    const unsigned greens[] = {0x4f8a4a, 0x3f7a52, 0x5f9448, 0x487f56};
    for (std::size_t i = 0; i < std::size(trees); ++i)
        paintTree(b, trunks, leaves, trees[i].first, trees[i].second, greens[i % 4]);

    // Shape is done; from here on only colour.
    const LayerId shade = b.layer(ground, "Shade of the trees", BlendMode::Multiply, 0.55, 0.12);
    for (const auto &[foot, height] : trees)
        for (int i = 0; i < 3; ++i) {
            const Point from = foot + Point(0.3f + 0.4f * float(i), -0.02f, 0.15f * float(i));
            b.stroke(shade, StrokeSection::Ellipse, {from, from + Point(0.35f * height, 0, 0.12f * height)},
                     {0.16f * height - 0.05f * float(i), 0.09f * height}, PaintingBrush::colour(0x6f86a8));
        }
    const LayerId pathShade = b.layer(path, "Shade on the path", BlendMode::Multiply, 0.5, 0.12);
    b.copies(shade, pathShade, Vec3(0, 0.08, 0));
    const LayerId bark = b.layer(trunks, "Bark", BlendMode::Normal, 0.75, 0.05);
    for (const auto &[foot, height] : trees)
        for (int i = 0; i < 4; ++i) {
            const float x = 0.05f * height * (float(i) / 1.5f - 1);
            const Point from = foot + Point(x, float(b.random.uniform(0.05, 0.25)) * height, 0.07f * height);
            b.stroke(bark, StrokeSection::Round,
                     {from, from + Point(-0.3f * x, 0.22f * height, -0.03f * height)},
                     {0.006f * height, 0.003f * height}, PaintingBrush::colour(i % 2 ? 0x4a3529 : 0x8a6a52));
        }
    const LayerId under = b.layer(leaves, "Shadow under the leaves", BlendMode::Multiply, 0.7);
    b.copies(leaves, under, Vec3(-0.16, -0.26, 0), 0.98);
    b.tint(under, 0x6d8aa0);
    const LayerId light = b.layer(leaves, "Sun on the leaves", BlendMode::Normal, 0.85);
    b.copies(leaves, light, Vec3(0.14, 0.2, 0.1), 0.82);
    b.tint(light, 0xc3d873);
    const LayerId dapples = b.layer(path, "Sunny spots", BlendMode::Screen, 0.55, 0.1);
    for (int i = 0; i < 24; ++i) {
        const float z = float(b.random.uniform(-8, 4));
        b.dab(dapples, {pathMiddle(z) + float(b.random.uniform(-0.5, 0.5)), 0.05f, z},
              float(b.random.uniform(0.07, 0.2)), PaintingBrush::colour(0xfff0b8), 0);
    }
    const LayerId mist = b.sceneLayer("Mist", BlendMode::Normal, 0.9);
    b.everything(mist, PaintingBrush::colour(0xf3d9cf));
    b.at(mist).properties.masks = {gradient({0, 0, 0.5}, {0, 0, -11}, 0.04, 0.82),
                                   gradient({0, 0.3, 0}, {0, 4.2, 0}, 1, 0.25)};
    const LayerId cool = b.sceneLayer("Night still below", BlendMode::Multiply, 0.75);
    b.everything(cool, PaintingBrush::colour(0x8f86c4));
    b.at(cool).properties.masks = {gradient({0, -0.2, 0}, {0, 4.5, 0}, 1, 0.15)};
    const LayerId glow = b.sceneLayer("Rising sun", BlendMode::Overlay, 0.85);
    b.everything(glow, PaintingBrush::colour(0xff9a5c));
    b.at(glow).properties.masks = {
        {true, false,
         GradientMask{
             GradientMask::Shape::Spherical, {2.5, 1.5, -13}, {2.5, 1.5, 3}, 1, 0.1, MaskEasing::Smooth}}};

    for (const LayerId id : {mist, cool, glow})
        b.hide(id);
    b.keepLook("Day");
    for (const LayerId id : {mist, cool, glow})
        b.hide(id, false);
    b.tint(light, 0xffb27a);
    b.tint(under, 0x5d6596);
    b.at(dapples).properties.opacity = 0.3;
    b.keepLook("Dawn");
    for (const auto &[id, properties] : b.painting.looks[0].layers)
        b.at(id).properties = properties;
    b.camera({0.55, 1.35, 7.2}, {0.15, 1.45, -3}, 42);
    return b.painting;
}

} // namespace ductus
