// A lighthouse: clouds and foam are noise, the glow is a gradient, the beam turns.
#include "support/painting_brush.h"
#include "support/painting_samples.h"

#include <cmath>
#include <numbers>

namespace ductus {

namespace {

using Point = PaintingBrush::Point;

constexpr float pi = std::numbers::pi_v<float>;
constexpr float towerX = 0.9f, towerZ = -1.0f, lampY = 4.02f;

Point c(unsigned rgb)
{
    return PaintingBrush::colour(rgb);
}

std::vector<Point> ring(float y, float radius)
{
    std::vector<Point> points;
    for (int k = 0; k <= 28; ++k) {
        const float angle = 2 * pi * float(k) / 28;
        points.push_back({towerX + radius * std::cos(angle), y, towerZ + radius * std::sin(angle)});
    }
    return points;
}

float towerRadius(float y)
{
    return 0.62f - 0.075f * y;
}

void paintSea(PaintingBrush &b, LayerId sea)
{
    const Point near = c(0x2f7f95), far = c(0x8fc3cf);
    for (float z = 5.5f; z > -15; z -= 0.36f) {
        const float t = std::clamp(-z / 15 + 0.15f, 0.f, 1.f);
        std::vector<Point> points;
        const float phase = float(b.random.uniform(0, 6.28));
        for (float x = -15; x <= 15; x += 1)
            points.push_back({x, -0.55f + 0.07f * (1 - t) * std::sin(1.5f * x + phase), z});
        b.stroke(sea, StrokeSection::Ellipse, points, {0.3f}, b.varied((1 - t) * near + t * far, 0.09f));
    }
}

void paintSky(PaintingBrush &b, LayerId sky, LayerId clouds)
{
    for (int i = 0; i < 20; ++i) {
        const float y = -1.2f + 0.85f * float(i), t = std::min(1.f, float(i) / 14);
        b.stroke(sky, StrokeSection::Ellipse,
                 {Point(-24, y, -16), Point(0, y + 0.15f, -16.5f), Point(24, y, -16)}, {0.6f},
                 (1 - t) * c(0xe9efe6) + t * c(0x6fb0d8), Point::UnitZ());
    }
    for (const auto &[x, y, size] :
         std::initializer_list<std::tuple<float, float, float>>{{-6.8f, 4.8f, 1.3f},
                                                                {-2.6f, 6.6f, 0.9f},
                                                                {5.6f, 5.6f, 1.5f},
                                                                {9.4f, 3.4f, 1.2f},
                                                                {-10.5f, 2.6f, 1.4f}})
        for (int k = 0; k < 8; ++k) {
            const float t = float(k) / 7 * 2 - 1;
            b.dab(clouds,
                  {x + 1.5f * size * t, y + 0.35f * size * (1 - t * t) * float(b.random.uniform(0.4, 1.1)),
                   -12.5f},
                  size * (0.3f + 0.32f * (1 - t * t)), b.varied(c(0xf5f5f2), 0.02f), 0.3f);
        }
}

void paintRock(PaintingBrush &b, LayerId rock, LayerId grass)
{
    for (int i = 0; i < 58; ++i) {
        const float angle = 2.4f * float(i), out = 2.15f * std::sqrt(float(i) / 58);
        const float y = 0.1f - 0.2f * out * out;
        const Point at(towerX - 0.1f + 1.25f * out * std::cos(angle), y,
                       towerZ + 0.95f * out * std::sin(angle));
        b.dab(rock, at, float(b.random.uniform(0.36, 0.56)), b.varied(c(0x8a7f78), 0.16f), 0.7f);
    }
    for (int i = 0; i < 26; ++i) {
        const float angle = 2.4f * float(i), out = 1.15f * std::sqrt(float(i) / 26);
        b.dab(grass,
              {towerX - 0.1f + 1.2f * out * std::cos(angle), 0.4f - 0.16f * out,
               towerZ + 0.9f * out * std::sin(angle)},
              0.26f, b.varied(c(0x84a85a), 0.15f), 0.35f);
    }
}

void paintTower(PaintingBrush &b, LayerId tower, LayerId lamp)
{
    for (float y = 0.35f; y < 3.6f; y += 0.085f)
        b.stroke(tower, StrokeSection::Round, ring(y, towerRadius(y) - 0.07f), {0.075f},
                 b.varied(c(0xf3efe4), 0.015f));
    b.stroke(tower, StrokeSection::Cube, ring(3.65f, 0.46f), {0.06f}, c(0x3f4a56)); // gallery
    b.stroke(tower, StrokeSection::Round, ring(3.92f, 0.52f), {0.018f}, c(0x3f4a56));
    for (int k = 0; k < 14; ++k) {
        const float angle = 2 * pi * float(k) / 14;
        const Point foot(towerX + 0.52f * std::cos(angle), 3.68f, towerZ + 0.52f * std::sin(angle));
        b.bar(tower, foot, foot + Point(0, 0.24f, 0), 0.012f, c(0x3f4a56));
    }
    for (int k = 0; k < 8; ++k) {
        const float angle = 2 * pi * (float(k) + 0.5f) / 8;
        const Point foot(towerX + 0.25f * std::cos(angle), 3.72f, towerZ + 0.25f * std::sin(angle));
        b.bar(tower, foot, foot + Point(0, 0.55f, 0), 0.022f, c(0x3f4a56));
    }
    for (int k = 0; k < 9; ++k) { // roof, ring by ring
        const float t = float(k) / 8;
        b.stroke(tower, StrokeSection::Round, ring(4.3f + 0.42f * t, 0.34f * (1 - t) + 0.01f),
                 {0.06f - 0.03f * t}, c(0xc0452f));
    }
    b.stroke(tower, StrokeSection::Round, {Point(towerX, 4.7f, towerZ), Point(towerX, 5.0f, towerZ)},
             {0.02f, 0.01f}, c(0x3f4a56));
    b.stroke(lamp, StrokeSection::Round,
             {Point(towerX, lampY - 0.14f, towerZ), Point(towerX, lampY + 0.14f, towerZ)}, {0.15f},
             c(0xf7e3a0));
    for (const float y : {1.0f, 1.9f, 2.8f}) { // windows
        const float z = towerZ + towerRadius(y) + 0.02f;
        b.stroke(tower, StrokeSection::Ellipse,
                 {Point(towerX - 0.2f, y, z - 0.06f), Point(towerX - 0.2f, y + 0.22f, z - 0.07f)}, {0.07f},
                 c(0x46505a), Point(-0.3f, 0, 1));
    }
    b.stroke(tower, StrokeSection::Ellipse,
             {Point(towerX + 0.08f, 0.38f, towerZ + 0.6f), Point(towerX + 0.08f, 0.78f, towerZ + 0.57f)},
             {0.14f}, c(0x7d4a36), Point::UnitZ());
}

void paintBoat(PaintingBrush &b, LayerId boat)
{
    const Point at(-3.1f, -0.32f, 0.6f);
    b.stroke(boat, StrokeSection::Ellipse,
             {at + Point(-0.62f, 0.16f, 0), at + Point(-0.3f, 0, 0), at + Point(0.3f, 0, 0),
              at + Point(0.68f, 0.2f, 0)},
             {0.04f, 0.17f, 0.17f, 0.03f}, c(0xb8503c), Point::UnitZ());
    b.bar(boat, at + Point(0, 0.1f, 0), at + Point(0, 1.5f, 0), 0.022f, c(0x6d5240));
    for (int k = 0; k < 12; ++k) { // sails in stripes
        const float y = 0.3f + 0.095f * float(k), out = 0.62f * (1 - (y - 0.3f) / 1.25f);
        b.stroke(boat, StrokeSection::Ellipse,
                 {at + Point(0.04f, y, 0), at + Point(0.06f + out, y - 0.02f, 0.06f)}, {0.1f},
                 b.varied(c(0xf4ecd8), 0.03f), Point::UnitZ());
        b.stroke(boat, StrokeSection::Ellipse,
                 {at + Point(-0.06f, y, 0), at + Point(-0.08f - 0.6f * out, y - 0.02f, 0.05f)}, {0.1f},
                 b.varied(c(0xe9d9b8), 0.03f), Point::UnitZ());
    }
}

// Two clear cones from the lamp; they turn about the tower.
std::vector<ElementId> paintBeam(PaintingBrush &b, LayerId beam)
{
    std::vector<ElementId> made;
    for (const float side : {-1.f, 1.f})
        made.push_back(
            b.stroke(beam, StrokeSection::Round,
                     {Point(towerX + 0.2f * side, lampY, towerZ), Point(towerX + 2.5f * side, lampY, towerZ),
                      Point(towerX + 7.5f * side, lampY - 0.1f, towerZ)},
                     {0.1f, 0.4f, 1.05f}, c(0xfff0b0)));
    return made;
}

Mask around(const Vec3 &centre, double radius, double from, double to)
{
    return {true, false,
            GradientMask{GradientMask::Shape::Spherical, centre, centre + Vec3(0, radius, 0), from, to,
                         MaskEasing::Smooth}};
}

} // namespace

Painting lighthouse()
{
    PaintingBrush b(71);
    b.painting.background = c(0xbcd9e4);
    const LayerId sky = b.stack("Sky"), clouds = b.stack("Clouds"), sea = b.stack("Sea"),
                  rock = b.stack("Rock"), grass = b.stack("Grass"), tower = b.stack("Tower"),
                  lamp = b.stack("Lamp"), boat = b.stack("Boat"), beam = b.stack("Beam");
    paintSky(b, sky, clouds);
    paintSea(b, sea);
    paintRock(b, rock, grass);
    paintTower(b, tower, lamp);
    paintBoat(b, boat);
    const std::vector<ElementId> turning = paintBeam(b, beam);
    b.at(beam).properties.opacity = 0.34;

    const LayerId stripes = b.layer(tower, "Stripes", BlendMode::Normal, 1, 0.03);
    for (const float y : {0.75f, 1.65f, 2.55f})
        for (int k = -2; k <= 2; ++k)
            b.stroke(stripes, StrokeSection::Round,
                     ring(y + 0.09f * float(k), towerRadius(y + 0.09f * float(k))), {0.055f}, c(0xc8482f));
    const LayerId towerShade = b.layer(tower, "Shade of the tower", BlendMode::Multiply, 0.6, 0.1);
    for (float y = 0.3f; y < 4.5f; y += 0.16f)
        b.stroke(towerShade, StrokeSection::Round,
                 {Point(towerX + towerRadius(y) - 0.1f, y, towerZ + 0.25f),
                  Point(towerX + towerRadius(y), y, towerZ - 0.5f)},
                 {0.21f}, c(0x8f93b8));
    const LayerId foam = b.layer(sea, "Foam around the rock", BlendMode::Screen, 0.9);
    b.everything(foam, c(0xffffff));
    NoiseMask noise;
    noise.cellSize = 0.55;
    noise.seed = 5;
    noise.threshold = 0.5;
    noise.softness = 0.12;
    b.at(foam).properties.masks = {{true, false, noise}, around({towerX - 0.1, -0.5, towerZ}, 4.6, 1, 0)};
    const LayerId glitter = b.layer(sea, "Crests", BlendMode::Screen, 0.4);
    b.everything(glitter, c(0xdff4f4));
    noise.cellSize = 0.32;
    noise.seed = 9;
    noise.threshold = 0.62;
    b.at(glitter).properties.masks = {{true, false, noise}};
    const LayerId wet = b.layer(rock, "Wet below", BlendMode::Multiply, 0.7);
    b.everything(wet, c(0x5d6a72));
    b.at(wet).properties.masks = {
        {true, false,
         GradientMask{GradientMask::Shape::Linear, {0, -0.5, 0}, {0, 0.1, 0}, 1, 0, MaskEasing::Smooth}}};
    const LayerId cloudShade = b.layer(clouds, "Shade of the clouds", BlendMode::Multiply, 0.6);
    b.copies(clouds, cloudShade, Vec3(0.1, -0.42, 0.1), 1.02);
    b.tint(cloudShade, 0xa9bcd6);

    const LayerId night = b.sceneLayer("Night", BlendMode::Multiply, 0.95);
    b.everything(night, c(0x2f4380));
    b.at(night).properties.masks = {around({towerX, lampY, towerZ}, 5.5, 0.1, 1)};
    const LayerId glow = b.sceneLayer("Glow of the lamp", BlendMode::Screen, 0.65);
    b.everything(glow, c(0xffc85a));
    b.at(glow).properties.masks = {around({towerX, lampY, towerZ}, 1.5, 0.95, 0)};
    const LayerId moon = b.sceneLayer("Moonlight over the sea", BlendMode::Overlay, 0.5);
    b.everything(moon, c(0xa9c4ff));
    b.at(moon).properties.masks = {around({-5, 0.5, -13}, 9, 0.9, 0)};

    // Half a turn in four seconds: the beams are two, so it closes.
    const auto key = [](double time, double angle) {
        PlacementKey made;
        made.timeSeconds = time;
        made.placement.rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY());
        const Eigen::Vector3d middle(towerX, lampY, towerZ);
        made.placement.translation = middle - made.placement.rotation * middle;
        return made;
    };
    std::vector<PlacementKey> turn; // few enough that the place between keys is about right
    for (int k = 0; k <= 12; ++k)
        turn.push_back(key(k / 3.0, 0.35 + std::numbers::pi * k / 12));
    b.addGroup("Beam", turning, turn);
    b.painting.loopSeconds = 4;
    const auto set = [&](bool isNight) {
        for (const LayerId id : {night, glow, moon, beam})
            b.hide(id, !isNight);
    };
    set(true);
    b.tint(lamp, 0xfff6d0);
    b.keepLook("Night");
    set(false);
    b.at(lamp).properties.colour.reset();
    b.keepLook("Noon");
    for (const auto &[id, properties] : b.painting.looks[0].layers)
        b.at(id).properties = properties;
    b.camera({-1.3, 1.75, 9.2}, {-0.35, 2.1, -1}, 38);
    return b.painting;
}

} // namespace ductus
