// A room in a box by day and by night (Fig. V.10).
#include "support/painting_brush.h"
#include "support/painting_samples.h"

#include <cmath>

namespace ductus {

namespace {

using Point = PaintingBrush::Point;

Point c(unsigned rgb)
{
    return PaintingBrush::colour(rgb);
}

struct Room
{
    LayerId floor, walls, window, desk, chair, lamp, things, plant;
};

void paintRoom(PaintingBrush &b, const Room &r)
{
    b.boards(r.floor, {-2, -0.1f, -2}, {2, -0.1f, 2}, false, 0.2f, c(0xb98a5e), 0.1f);
    for (int i = 0; i < 20; ++i) { // walls in upright strokes, around the window
        const float x = -1.9f + 0.2f * float(i);
        b.stroke(r.walls, StrokeSection::Cube,
                 {Point(x, 0, -2.1f), Point(x, 1.3f, -2.1f), Point(x, 2.6f, -2.1f)}, {0.1f},
                 b.varied(c(0x9fb5b0), 0.03f), Point::UnitZ());
        const float z = -1.9f + 0.2f * float(i);
        const Point wall = b.varied(c(0xafc3bc), 0.03f);
        if (z > -0.9f && z < 0.5f) {
            b.stroke(r.walls, StrokeSection::Cube, {Point(-2.1f, 0, z), Point(-2.1f, 0.9f, z)}, {0.1f}, wall,
                     Point::UnitX());
            b.stroke(r.walls, StrokeSection::Cube, {Point(-2.1f, 2.2f, z), Point(-2.1f, 2.6f, z)}, {0.1f},
                     wall, Point::UnitX());
        } else {
            b.stroke(r.walls, StrokeSection::Cube, {Point(-2.1f, 0, z), Point(-2.1f, 2.6f, z)}, {0.1f}, wall,
                     Point::UnitX());
        }
    }
    b.bar(r.walls, {-2, 0.08f, -1.98f}, {2, 0.08f, -1.98f}, 0.06f, c(0xe9e4d8)); // skirting
    b.bar(r.walls, {-1.98f, 0.08f, -2}, {-1.98f, 0.08f, 2}, 0.06f, c(0xe9e4d8));
    const Point frame = c(0xf3efe6);
    for (const float z : {-0.92f, -0.2f, 0.52f})
        b.bar(r.window, {-2.06f, 0.9f, z}, {-2.06f, 2.2f, z}, 0.045f, frame);
    for (const float y : {0.9f, 1.55f, 2.2f})
        b.bar(r.window, {-2.06f, y, -0.92f}, {-2.06f, y, 0.52f}, 0.045f, frame);
    b.boards(r.window, {-2.05f, 0.86f, -1}, {-1.85f, 0.86f, 0.6f}, false, 0.1f, frame, 0.02f);
    for (int ring = 0; ring < 6; ++ring) { // rug
        std::vector<Point> points;
        for (int k = 0; k <= 28; ++k) {
            const float t = 6.2832f * float(k) / 28, radius = 0.1f + 0.16f * float(ring);
            points.push_back({0.55f + radius * std::cos(t), 0.02f, 0.75f + 0.8f * radius * std::sin(t)});
        }
        b.stroke(r.floor, StrokeSection::Ellipse, points, {0.085f},
                 b.varied(c(ring % 2 ? 0xd9c7a3 : 0xb5614f), 0.05f));
    }
}

void paintDesk(PaintingBrush &b, const Room &r)
{
    const Point wood = c(0x9a6a45);
    b.boards(r.desk, {-1.1f, 1.0f, -1.75f}, {1.3f, 1.0f, -0.85f}, true, 0.09f, wood, 0.07f);
    for (const float x : {-1.0f, 1.2f})
        for (const float z : {-1.65f, -0.95f})
            b.bar(r.desk, {x, 0.02f, z}, {x, 0.97f, z}, 0.05f, b.varied(c(0x7b5236)));
    for (int k = 0; k < 3; ++k) { // drawers
        b.boards(r.desk, {0.55f, 0.32f + 0.24f * float(k), -1.6f}, {1.15f, 0.32f + 0.24f * float(k), -0.92f},
                 true, 0.2f, c(0x8a5d3d), 0.04f);
        b.bar(r.desk, {0.78f, 0.34f + 0.24f * float(k), -0.8f}, {0.92f, 0.34f + 0.24f * float(k), -0.8f},
              0.02f, c(0xd9b36a));
    }
    // Chair
    const Point seat = c(0x4f7f8f);
    b.boards(r.chair, {-0.15f, 0.58f, -0.35f}, {0.45f, 0.58f, 0.2f}, true, 0.09f, seat, 0.06f);
    for (const float x : {-0.1f, 0.4f}) {
        for (const float z : {-0.3f, 0.15f})
            b.bar(r.chair, {x, 0.02f, z}, {x, 0.56f, z}, 0.03f, c(0x5b4636));
        b.bar(r.chair, {x, 0.6f, 0.17f}, {x, 1.3f, 0.26f}, 0.03f, c(0x5b4636));
    }
    for (int k = 0; k < 5; ++k)
        b.bar(r.chair, {-0.1f, 0.85f + 0.1f * float(k), 0.2f + 0.01f * float(k)},
              {0.4f, 0.85f + 0.1f * float(k), 0.2f + 0.01f * float(k)}, 0.045f, b.varied(seat, 0.07f));
    // Lamp; the last stroke but two is its bulb
    const Point metal = c(0x3f4a56);
    b.stroke(r.lamp, StrokeSection::Round, {Point(-0.85f, 1.08f, -1.5f), Point(-0.65f, 1.08f, -1.5f)},
             {0.09f}, metal);
    b.stroke(r.lamp, StrokeSection::Round,
             {Point(-0.75f, 1.1f, -1.5f), Point(-0.9f, 1.45f, -1.5f), Point(-0.62f, 1.75f, -1.42f)}, {0.025f},
             metal);
    for (int k = 0; k < 14; ++k) { // shade in upright strokes
        const float t = 6.2832f * float(k) / 14;
        const Point top(-0.55f + 0.06f * std::cos(t), 1.86f, -1.38f + 0.06f * std::sin(t));
        const Point low(-0.5f + 0.2f * std::cos(t), 1.66f, -1.33f + 0.2f * std::sin(t));
        b.stroke(r.lamp, StrokeSection::Round, {top, low}, {0.03f, 0.05f}, b.varied(c(0xd9a441), 0.05f));
    }
}

void paintThings(PaintingBrush &b, const Room &r)
{
    // Screen and keyboard
    b.boards(r.things, {-0.25f, 1.2f, -1.62f}, {0.55f, 1.2f, -1.6f}, true, 0.05f, c(0x2e3440), 0.02f);
    for (int k = 0; k < 8; ++k)
        b.bar(r.things, {-0.25f, 1.2f + 0.06f * float(k), -1.6f}, {0.55f, 1.2f + 0.06f * float(k), -1.6f},
              0.032f, b.varied(c(k == 0 || k == 7 ? 0x2b303a : 0x39506b), 0.05f));
    b.bar(r.things, {0.15f, 1.06f, -1.6f}, {0.15f, 1.2f, -1.6f}, 0.04f, c(0x2b303a));
    for (int row = 0; row < 4; ++row)
        for (int k = 0; k < 9; ++k)
            b.bar(r.things, {-0.12f + 0.06f * float(k), 1.065f, -1.22f + 0.06f * float(row)},
                  {-0.085f + 0.06f * float(k), 1.065f, -1.22f + 0.06f * float(row)}, 0.02f, c(0xdcdcd6));
    // Books on the desk and on two shelves
    const unsigned spines[] = {0xc8553d, 0x3d6fa8, 0xe0b04c, 0x5f8f5f,
                               0x8c5a8c, 0xd8d0bd, 0x40606f, 0xb0446a};
    for (int k = 0; k < 5; ++k)
        b.bar(r.things, {0.75f, 1.1f + 0.075f * float(k), -1.45f + 0.03f * float(k % 2)},
              {1.12f, 1.1f + 0.075f * float(k), -1.4f}, 0.037f, b.varied(c(spines[k]), 0.1f));
    for (int shelf = 0; shelf < 2; ++shelf) {
        const float y = 1.75f + 0.45f * float(shelf);
        b.boards(r.things, {0.4f, y, -1.98f}, {1.8f, y, -1.72f}, true, 0.07f, c(0x8a5d3d), 0.05f);
        float x = 0.48f;
        while (x < 1.7f) {
            const float height = float(b.random.uniform(0.2, 0.32)),
                        width = float(b.random.uniform(0.022, 0.042));
            for (const float z : {-1.9f, -1.82f}) // spine and block
                b.bar(r.things, {x, y + 0.05f, z},
                      {x + (b.random.index(5) == 0 ? 0.04f : 0.f), y + 0.05f + height, z}, width,
                      b.varied(c(spines[b.random.index(8)]), 0.1f));
            x += 2.3f * width;
        }
    }
    // Mug, pens, pictures, boxes, bin
    for (int k = 0; k < 10; ++k) {
        const float t = 6.2832f * float(k) / 10;
        b.stroke(r.things, StrokeSection::Round,
                 {Point(0.64f + 0.06f * std::cos(t), 1.07f, -1.08f + 0.06f * std::sin(t)),
                  Point(0.64f + 0.065f * std::cos(t), 1.2f, -1.08f + 0.065f * std::sin(t))},
                 {0.022f}, c(0xf0ece0));
    }
    for (int k = 0; k < 6; ++k)
        b.stroke(r.things, StrokeSection::Round,
                 {Point(-0.42f, 1.08f, -1.55f),
                  Point(-0.42f + 0.03f * float(k - 3), 1.34f, -1.55f + 0.02f * float(k % 3))},
                 {0.012f, 0.01f}, c(spines[k]));
    for (int k = 0; k < 3; ++k) {
        const float x = -1.5f + 0.55f * float(k), y = 1.75f + 0.1f * float(k % 2);
        for (int line = 0; line < 5; ++line)
            b.bar(r.things, {x, y + 0.07f * float(line), -1.97f},
                  {x + 0.36f, y + 0.07f * float(line), -1.97f}, 0.036f,
                  b.varied(c(line == 0 || line == 4 ? 0x5b4636 : spines[(k + line) % 8]), 0.1f));
    }
    for (int k = 0; k < 12; ++k) {
        const float t = 6.2832f * float(k) / 12;
        b.stroke(r.things, StrokeSection::Round,
                 {Point(-0.7f + 0.14f * std::cos(t), 0.03f, -1.2f + 0.14f * std::sin(t)),
                  Point(-0.7f + 0.18f * std::cos(t), 0.42f, -1.2f + 0.18f * std::sin(t))},
                 {0.04f}, b.varied(c(0x77838c), 0.06f));
    }
    // Plant in its pot
    for (int k = 0; k < 10; ++k) {
        const float t = 6.2832f * float(k) / 10;
        b.stroke(r.plant, StrokeSection::Round,
                 {Point(1.5f + 0.14f * std::cos(t), 0.04f, -0.3f + 0.14f * std::sin(t)),
                  Point(1.5f + 0.2f * std::cos(t), 0.42f, -0.3f + 0.2f * std::sin(t))},
                 {0.07f}, b.varied(c(0xb8674a), 0.05f));
    }
    for (int k = 0; k < 34; ++k) {
        const float t = 2.4f * float(k), up = float(k) / 34;
        const Point foot(1.5f, 0.4f, -0.3f);
        const Point tip = foot + Point((0.2f + 0.42f * (1 - up)) * std::cos(t), 0.35f + 0.85f * up,
                                       (0.2f + 0.42f * (1 - up)) * std::sin(t));
        const Point bend = 0.5f * (foot + tip) + Point(0, 0.22f, 0);
        b.stroke(r.plant, StrokeSection::Ellipse,
                 {foot, bend, 0.4f * bend + 0.6f * tip + Point(0, 0.05f, 0), tip},
                 {0.015f, 0.06f, 0.07f, 0.004f}, b.varied(c(0x4f8f55), 0.2f));
    }
}

Mask sphere(const Vec3 &centre, double radius, double from, double to)
{
    return {true, false,
            GradientMask{GradientMask::Shape::Spherical, centre, centre + Vec3(0, radius, 0), from, to,
                         MaskEasing::Smooth}};
}

} // namespace

Painting deskDiorama()
{
    PaintingBrush b(37);
    b.painting.background = c(0xd8dde0);
    Room r;
    r.floor = b.stack("Floor");
    r.walls = b.stack("Walls");
    r.window = b.stack("Window");
    r.desk = b.stack("Desk");
    r.chair = b.stack("Chair");
    r.lamp = b.stack("Lamp");
    r.things = b.stack("Things");
    r.plant = b.stack("Plant");
    paintRoom(b, r);
    paintDesk(b, r);
    paintThings(b, r);
    const LayerId bulbStack = b.stack("Bulb");
    b.dab(bulbStack, {-0.5f, 1.68f, -1.33f}, 0.09f, c(0x4a4a4a), 0);

    const LayerId outside = b.stack("Outside");
    for (int k = 0; k < 8; ++k) {
        const float z = -0.85f + 0.2f * float(k);
        b.shaded(outside, StrokeSection::Cube,
                 {Point(-2.3f, 0.7f, z), Point(-2.3f, 1.5f, z), Point(-2.3f, 2.4f, z)}, 0.11f, c(0xe6f2f5),
                 c(0x8fc4e6), Point::UnitX());
    }

    // Light of the day: a beam on the floor, cut by a copy of the window's own frame.
    const LayerId beam = b.layer(r.floor, "Sunbeam", BlendMode::Screen, 0.55, 0.12);
    for (int k = 0; k < 7; ++k) {
        const float z = -0.55f + 0.2f * float(k);
        b.stroke(beam, StrokeSection::Cube, {Point(-1.25f, 0.0f, z), Point(0.6f, 0.0f, z + 0.35f)}, {0.105f},
                 c(0xffe0a0));
    }
    const LayerId bars = b.layer(r.floor, "Window frame in the beam", BlendMode::Multiply, 0.85, 0.12);
    for (const float t : {0.f, 0.5f, 1.f})
        b.bar(bars, {-1.25f + 1.85f * t, 0, -0.65f + 0.35f * t}, {-1.25f + 1.85f * t, 0, 0.75f + 0.35f * t},
              0.045f, c(0x9a8a80));
    for (const float z : {-0.65f, 0.05f, 0.75f})
        b.bar(bars, {-1.25f, 0, z}, {0.6f, 0, z + 0.35f}, 0.045f, c(0x9a8a80));
    const LayerId dayShadow = b.layer(r.floor, "Shadows by day", BlendMode::Multiply, 0.6, 0.1);
    b.boards(dayShadow, {-0.6f, 0, -1.7f}, {1.9f, 0, -0.65f}, true, 0.12f, c(0x8f86a0), 0, 1.15f);
    b.boards(dayShadow, {0.1f, 0, -0.3f}, {0.95f, 0, 0.35f}, true, 0.1f, c(0x8f86a0), 0, 1.15f);
    b.dab(dayShadow, {1.62f, 0, -0.22f}, 0.4f, c(0x8f86a0), 0);
    const LayerId nightShadow = b.layer(r.floor, "Shadows by night", BlendMode::Multiply, 0.7, 0.1);
    b.boards(nightShadow, {-1.2f, 0, -1.75f}, {1.4f, 0, -0.5f}, true, 0.12f, c(0x5f5a78), 0, 1.15f);
    b.boards(nightShadow, {-0.15f, 0, -0.1f}, {0.8f, 0, 0.75f}, true, 0.1f, c(0x6f6a88), 0, 1.15f);
    const LayerId wallShade = b.layer(r.walls, "Corner shade", BlendMode::Multiply, 0.5, 0.1);
    b.stroke(wallShade, StrokeSection::Round, {Point(-2.05f, -0.1f, -2.05f), Point(-2.05f, 2.7f, -2.05f)},
             {0.6f}, c(0x8795a0));
    const auto shading = [&](LayerId of, const Vec3 &light, unsigned bright, unsigned dark) {
        const LayerId shade = b.layer(of, "Shade", BlendMode::Multiply, 0.55);
        b.copies(of, shade, -0.03 * light);
        b.tint(shade, dark);
        const LayerId sun = b.layer(of, "Light", BlendMode::Screen, 0.35);
        b.copies(of, sun, 0.035 * light);
        b.tint(sun, bright);
        return sun;
    };
    const Vec3 fromWindow(-1, 0.8, 0.5);
    std::vector<LayerId> lights;
    for (const LayerId of : {r.desk, r.chair, r.lamp, r.plant})
        lights.push_back(shading(of, fromWindow, 0xffe9bd, 0x8d88a8));
    const LayerId night = b.sceneLayer("Night", BlendMode::Multiply, 0.92);
    b.everything(night, c(0x3c4a80));
    b.at(night).properties.masks = {sphere({-0.45, 1.5, -1.3}, 3.2, 0.25, 1)};
    const LayerId lampLight = b.sceneLayer("Lamp light", BlendMode::Overlay, 0.95);
    b.everything(lampLight, c(0xffc266));
    b.at(lampLight).properties.masks = {sphere({-0.45, 1.35, -1.25}, 2.1, 1, 0)};
    const LayerId glow = b.sceneLayer("Glow of the lamp", BlendMode::Screen, 0.6);
    b.everything(glow, c(0xffb347));
    b.at(glow).properties.masks = {sphere({-0.48, 1.55, -1.3}, 0.75, 0.75, 0)};

    for (const LayerId id : {night, lampLight, glow, nightShadow})
        b.hide(id);
    b.keepLook("Day");
    for (const LayerId id : {night, lampLight, glow, nightShadow})
        b.hide(id, false);
    for (const LayerId id : {beam, bars, dayShadow})
        b.hide(id);
    for (const LayerId id : lights)
        b.at(id).properties.opacity = 0.1;
    b.tint(bulbStack, 0xfff3c4);
    b.tint(outside, 0x8fa6ff);
    b.keepLook("Night");
    for (const auto &[id, properties] : b.painting.looks[0].layers)
        b.at(id).properties = properties;
    b.camera({5.0, 3.9, 5.6}, {-0.15, 0.85, -0.5}, 31);
    return b.painting;
}

} // namespace ductus
