// A fire at night: its flames are drawings shown one after another, its light is layers.
#include "support/painting_brush.h"
#include "support/painting_samples.h"

#include <cmath>

namespace ductus {

namespace {

using Point = PaintingBrush::Point;

constexpr int flameDrawings = 5;

Point c(unsigned rgb)
{
    return PaintingBrush::colour(rgb);
}

void paintGround(PaintingBrush &b, LayerId ground)
{
    for (float z = 4.2f; z > -9; z -= 0.5f) {
        std::vector<Point> points;
        for (float x = -9; x <= 9; x += 2.25f)
            points.push_back(
                {x, -0.32f + 0.06f * std::sin(1.1f * x + 2 * z), z + 0.12f * float(b.random.normal())});
        b.stroke(ground, StrokeSection::Ellipse, points, {0.42f}, b.varied(c(0x6d8a5a), 0.12f));
    }
    for (int i = 0; i < 60; ++i) {
        const float angle = float(b.random.uniform(0, 6.28)), out = float(b.random.uniform(1.6, 4.2));
        const Point foot(out * std::cos(angle), -0.12f, 0.8f * out * std::sin(angle));
        const Point tip =
            foot + Point(0.1f * float(b.random.normal()), float(b.random.uniform(0.14, 0.32)), 0);
        b.stroke(ground, StrokeSection::Round, {foot, 0.5f * (foot + tip), tip}, {0.04f, 0.03f, 0.004f},
                 b.varied(c(0x7f9c5c), 0.2f));
    }
}

void paintPine(PaintingBrush &b, LayerId trees, const Point &foot, float height)
{
    b.stroke(trees, StrokeSection::Round, {foot - Point(0, 0.2f, 0), foot + Point(0, 0.95f * height, 0)},
             {0.035f * height, 0.01f * height}, c(0x5d4636));
    const int tiers = 7;
    for (int tier = 0; tier < tiers; ++tier) {
        const float t = float(tier) / tiers, y = (0.2f + 0.76f * t) * height,
                    out = 0.27f * height * (1.08f - t);
        for (int k = 0; k < 9; ++k) {
            const float angle = 0.7f * float(k) + 0.5f * float(tier);
            const Point from = foot + Point(0, y + 0.09f * height, 0);
            const Point to = foot + Point(out * std::cos(angle), y - 0.035f * height, out * std::sin(angle));
            b.stroke(trees, StrokeSection::Round,
                     {from, 0.5f * (from + to) + Point(0, 0.015f * height, 0), to},
                     {0.012f * height, (0.05f - 0.03f * t) * height, 0.008f * height},
                     b.varied(c(0x4f7f5c), 0.14f));
        }
    }
}

void paintTent(PaintingBrush &b, LayerId tent)
{
    const Point front(-2.0f, 1.3f, -1.5f), back(-4.3f, 1.15f, -2.9f);
    const Point along = (back - front).normalized();
    const Point across(-along.z(), 0, along.x()); // away from the camera
    const int cloths = 13;
    for (int k = 0; k <= cloths; ++k) { // over the ridge
        const Point ridge = front + float(k) / float(cloths) * (back - front);
        for (const float side : {-1.f, 1.f})
            b.stroke(tent, StrokeSection::Ellipse,
                     {ridge, ridge + 0.42f * side * across - Point(0, 0.62f, 0),
                      ridge + 0.95f * side * across - Point(0, 1.4f, 0)},
                     {0.14f}, b.varied(c(k % 4 == 1 ? 0xefe3c4 : 0xd9824a), 0.04f),
                     side * across + Point(0, 0.6f, 0));
    }
    for (int k = 0; k <= 8; ++k) { // the dark inside, in upright strokes
        const float t = float(k) / 4 - 1;
        const Point foot = front + 0.06f * along + 0.86f * t * across - Point(0, 1.4f, 0);
        b.stroke(tent, StrokeSection::Ellipse, {foot, foot + Point(0, 1.3f * (1 - std::abs(t)), 0)},
                 {0.14f, 0.05f}, c(0x5c3d34), along);
    }
    for (const float side : {-1.f, 1.f})
        b.bar(tent, front + Point(0, 0.1f, 0) - 0.05f * along,
              front + 1.0f * side * across - Point(0, 1.42f, 0) - 0.05f * along, 0.035f, c(0x6d5240));
}

void paintFireplace(PaintingBrush &b, LayerId wood, LayerId stones)
{
    for (int k = 0; k < 12; ++k) {
        const float angle = 0.5236f * float(k);
        b.dab(stones, {0.95f * std::cos(angle), -0.05f, 0.95f * std::sin(angle)},
              float(b.random.uniform(0.16, 0.23)), b.varied(c(0x96938e), 0.14f), 0.5f);
    }
    for (int k = 0; k < 6; ++k) {
        const float angle = 1.05f * float(k) + 0.25f;
        const Point out(0.72f * std::cos(angle), -0.02f, 0.72f * std::sin(angle));
        b.shaded(wood, StrokeSection::Round, {out, 0.35f * out + Point(0, 0.36f, 0), Point(0, 0.62f, 0)},
                 0.085f, b.varied(c(0x7d5a40), 0.1f), c(0x3a2a26));
    }
    for (const auto &[from, to] : std::initializer_list<std::pair<Point, Point>>{
             {{1.5f, 0.0f, 0.7f}, {2.35f, 0.0f, -0.75f}},
             {{-1.95f, 0.0f, 0.35f}, {-0.95f, 0.0f, 1.75f}}}) { // to sit on
        b.stroke(wood, StrokeSection::Round, {from, to}, {0.25f}, c(0x84624a));
        b.stroke(wood, StrokeSection::Round, {from - 0.1f * (to - from), from}, {0.19f}, c(0xc9a47a));
        b.stroke(wood, StrokeSection::Round, {to, to + 0.1f * (to - from)}, {0.19f}, c(0xc9a47a));
    }
}

// Tongues of one drawing: all stand on the wood, each drawing bends them another way.
void drawFlame(PaintingBrush &b, LayerId flame, int drawing)
{
    const float sway = 0.16f * std::sin(6.2832f * float(drawing) / flameDrawings);
    struct Kind
    {
        int count;
        float out, height, width;
        unsigned low, high;
        float forward; // to be seen before the others
    };
    for (const Kind &kind : {Kind{9, 0.34f, 1.2f, 0.2f, 0xffc04a, 0xe8482a, 0.f},
                             Kind{7, 0.2f, 1.05f, 0.16f, 0xffd860, 0xff9a2f, 0.2f},
                             Kind{5, 0.1f, 0.72f, 0.13f, 0xfff6c0, 0xffdf6a, 0.36f}})
        for (int k = 0; k < kind.count; ++k) {
            const float angle = 6.2832f * float(k) / float(kind.count) + 0.9f * float(drawing);
            const float high = kind.height * float(b.random.uniform(0.72, 1.15));
            const Point foot(kind.out * std::cos(angle), 0.22f, kind.out * std::sin(angle) + kind.forward);
            const Point tip(0.35f * foot.x() + sway + 0.12f * std::sin(2 * angle), 0.3f + high,
                            0.35f * foot.z() + 0.4f * kind.forward);
            const Point middle = 0.55f * foot + 0.45f * tip + Point(-0.6f * sway, 0, 0);
            StrokeShape shape;
            const Point low = c(kind.low), top = c(kind.high);
            shape.points = {{foot, Point::UnitZ(), 0.6f * kind.width, low, 1},
                            {0.5f * (foot + middle), Point::UnitZ(), kind.width, low, 1},
                            {middle, Point::UnitZ(), 0.75f * kind.width, 0.5f * (low + top), 1},
                            {tip, Point::UnitZ(), 0.006f, top, 1}};
            b.add(b.at(flame), shape);
        }
    // What was just drawn becomes a drawing of its own.
    Layer &layer = b.at(flame);
    if (drawing > 0) {
        layer.drawings.push_back(std::move(layer.drawings[0]));
        layer.drawings[0] = {};
    }
}

void keepFlame(PaintingBrush &b, LayerId flame)
{
    for (int drawing = flameDrawings - 1; drawing >= 0; --drawing)
        drawFlame(b, flame, drawing); // the last one stays in the first place
    Layer &layer = b.at(flame);
    layer.frames.framesPerSecond = 8;
    layer.frames.drawingOfFrame.clear();
    for (int drawing = 0; drawing < flameDrawings; ++drawing)
        layer.frames.drawingOfFrame.push_back(drawing);
}

Mask around(const Vec3 &centre, double radius, double from, double to)
{
    return {true, false,
            GradientMask{GradientMask::Shape::Spherical, centre, centre + Vec3(0, radius, 0), from, to,
                         MaskEasing::Smooth}};
}

} // namespace

Painting campfire()
{
    PaintingBrush b(67);
    b.painting.background = c(0x1b2440);
    const LayerId sky = b.stack("Sky"), ground = b.stack("Ground"), trees = b.stack("Pines"),
                  tent = b.stack("Tent"), stones = b.stack("Stones"), wood = b.stack("Wood"),
                  flame = b.stack("Flames"), sparks = b.stack("Sparks");
    for (int i = 0; i < 14; ++i) {
        const float y = -1.5f + 0.9f * float(i), t = float(i) / 13;
        b.stroke(sky, StrokeSection::Ellipse,
                 {Point(-18, y, -12), Point(0, y + 0.2f, -12.6f), Point(18, y, -12)}, {0.62f},
                 (1 - t) * c(0x5a6fa6) + t * c(0x1d2a58), Point::UnitZ());
    }
    for (int i = 0; i < 60; ++i)
        b.dab(sky, {float(b.random.uniform(-11, 11)), float(b.random.uniform(3.0, 9.5)), -11.2f},
              float(b.random.uniform(0.018, 0.05)), c(0xf6f1d8), 0);
    b.stroke(sky, StrokeSection::Round, {Point(4.3f, 5.4f, -11.2f), Point(4.35f, 5.4f, -11.2f)}, {0.62f},
             c(0xf4ecd0));
    paintGround(b, ground);
    const std::pair<Point, float> pines[] = {{{3.3f, -0.1f, -2.6f}, 4.2f},  {{4.9f, -0.1f, -1.2f}, 3.6f},
                                             {{-5.6f, -0.1f, -2.4f}, 4.4f}, {{1.3f, -0.1f, -5.4f}, 4.0f},
                                             {{-1.4f, -0.1f, -6.2f}, 4.6f}, {{6.4f, -0.1f, -4.4f}, 4.8f}};
    for (const auto &[foot, height] : pines)
        paintPine(b, trees, foot, height);
    paintTent(b, tent);
    paintFireplace(b, wood, stones);
    keepFlame(b, flame);
    for (int i = 0; i < 16; ++i)
        b.dab(sparks,
              {0.35f * float(b.random.normal()), float(b.random.uniform(1.0, 2.6)),
               0.3f * float(b.random.normal())},
              float(b.random.uniform(0.015, 0.032)), c(0xffb84a), 0);

    // Night over all, and the fire's light over the night.
    const LayerId night = b.sceneLayer("Night", BlendMode::Multiply, 0.9);
    b.everything(night, c(0x45558f));
    b.at(night).properties.masks = {
        around({0, 0.8, 0}, 4.6, 0.12, 1),
        {true, false,
         GradientMask{
             GradientMask::Shape::Linear, {0, 0, -8.5}, {0, 0, -10.5}, 1, 0.25, MaskEasing::Smooth}}};
    const LayerId light = b.sceneLayer("Light of the fire", BlendMode::Overlay, 0.85);
    b.everything(light, c(0xffa04a));
    b.at(light).properties.masks = {around({0, 0.7, 0}, 4.4, 1, 0)};
    const LayerId glow = b.sceneLayer("Glow", BlendMode::Screen, 0.55);
    b.everything(glow, c(0xff8a2f));
    b.at(glow).properties.masks = {around({0, 0.5, 0}, 1.7, 0.9, 0)};
    const LayerId dark = b.layer(ground, "Shadows away from the fire", BlendMode::Multiply, 0.55, 0.14);
    for (const auto &[foot, height] : pines) {
        const Point away = foot.normalized();
        b.stroke(dark, StrokeSection::Ellipse, {foot + 0.1f * away, foot + 0.45f * height * away},
                 {0.14f, 0.42f}, c(0x4a5578));
    }
    for (int k = 0; k < 12; ++k) {
        const float angle = 0.5236f * float(k);
        const Point at(std::cos(angle), -0.14f, std::sin(angle));
        b.stroke(dark, StrokeSection::Ellipse, {1.02f * at, 1.45f * at}, {0.17f, 0.08f}, c(0x4a5578));
    }

    // Sparks rise and are back in two seconds.
    std::vector<ElementId> flying;
    for (const Element &element : b.at(sparks).drawings[0].elements)
        flying.push_back(element.id);
    const auto key = [](double time, double y) {
        PlacementKey made;
        made.timeSeconds = time;
        made.placement.translation = {0.1 * std::sin(5 * time), y, 0};
        return made;
    };
    b.addGroup("Sparks", flying, {key(0, -0.6), key(1, 0.3), key(2, 1.2)});
    b.painting.loopSeconds = 2.5;
    b.keepLook("Night");
    b.hide(night);
    b.hide(glow);
    b.at(light).properties.opacity = 0.35;
    b.keepLook("Evening");
    for (const auto &[id, properties] : b.painting.looks[0].layers)
        b.at(id).properties = properties;
    b.camera({0.9, 2.5, 7.6}, {-0.15, 1.15, -0.8}, 40);
    return b.painting;
}

} // namespace ductus
