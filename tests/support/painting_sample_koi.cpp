// Koi in a pond from above: their spots are strokes that colour only the fish they touch.
#include "base/assert.h"
#include "support/painting_brush.h"
#include "support/painting_samples.h"

#include <cmath>
#include <numbers>

namespace ductus {

namespace {

using Point = PaintingBrush::Point;

constexpr float pi = std::numbers::pi_v<float>;

Point c(unsigned rgb)
{
    return PaintingBrush::colour(rgb);
}

// A fish lies along a bow: its place on it from nose (0) to tail (1), and across.
struct Bow
{
    Point middle; // of the circle it swims on
    float radius, angle, length;

    Point at(float t, float side = 0, float up = 0) const
    {
        const float turn = angle - t * length / radius;
        const float bend = 0.05f * std::sin(2 * pi * t) * t;
        const float out = radius + bend + side;
        return middle + Point(out * std::cos(turn), up, -out * std::sin(turn));
    }
};

struct Layers
{
    LayerId fish, spots, fins, backs;
};

// The elements it is made of, to swim as one.
std::vector<ElementId> paintFish(PaintingBrush &b, const Layers &layers, const Bow &bow, unsigned body,
                                 unsigned spot)
{
    std::vector<ElementId> made;
    std::vector<Point> spine;
    for (int k = 0; k <= 10; ++k)
        spine.push_back(bow.at(0.1f * float(k)));
    const float w = 0.17f * bow.length;
    made.push_back(b.stroke(
        layers.fish, StrokeSection::Round, spine,
        {0.4f * w, 0.78f * w, w, w, 0.94f * w, 0.8f * w, 0.62f * w, 0.45f * w, 0.3f * w, 0.18f * w, 0.1f * w},
        c(body)));
    for (const float side : {-1.f, 1.f}) {
        made.push_back(
            b.stroke(layers.fins, StrokeSection::Ellipse,
                     {bow.at(0.28f, 0.8f * w * side, -0.02f), bow.at(0.38f, 1.7f * w * side, -0.03f),
                      bow.at(0.5f, 2.2f * w * side, -0.05f)},
                     {0.3f * w, 0.5f * w, 0.1f * w}, c(0xf4ded0)));
        made.push_back(
            b.stroke(layers.fins, StrokeSection::Ellipse,
                     {bow.at(0.96f), bow.at(1.1f, 0.5f * w * side), bow.at(1.26f, 1.05f * w * side)},
                     {0.12f * w, 0.42f * w, 0.06f * w}, c(0xf4ded0)));
        made.push_back(
            b.stroke(layers.backs, StrokeSection::Round,
                     {bow.at(0.03f, 0.36f * w * side, 0.2f * w), bow.at(0.05f, 0.38f * w * side, 0.22f * w)},
                     {0.13f * w}, c(0x22242c)));
        made.push_back(b.stroke(layers.backs, StrokeSection::Round, // whiskers
                                {bow.at(-0.01f, 0.25f * w * side, 0), bow.at(-0.07f, 0.55f * w * side, 0)},
                                {0.05f * w, 0.02f * w}, c(0xf4ded0)));
    }
    for (const float t : {0.12f, 0.33f, 0.52f, 0.72f}) {
        const float side = float(b.random.uniform(-0.5, 0.5)) * w;
        made.push_back(b.stroke(
            layers.spots, StrokeSection::Round,
            {bow.at(t, side, 0.55f * w), bow.at(t + 0.07f, 0.4f * side, 0.6f * w)},
            {w * float(b.random.uniform(0.5, 0.72)), w * float(b.random.uniform(0.4, 0.6))}, c(spot)));
    }
    return made;
}

void paintPond(PaintingBrush &b, LayerId bottom, LayerId stones)
{
    for (float z = -4.6f; z < 4.7f; z += 0.42f) {
        std::vector<Point> points;
        for (float x = -6.4f; x <= 6.5f; x += 1.6f)
            points.push_back(
                {x, -1.5f + 0.05f * std::sin(2 * x + 3 * z), z + 0.08f * float(b.random.normal())});
        b.stroke(bottom, StrokeSection::Ellipse, points, {0.38f}, b.varied(c(0x7fa39a), 0.09f));
    }
    for (int i = 0; i < 90; ++i) // pebbles on the ground
        b.dab(bottom, {float(b.random.uniform(-5.5, 5.5)), -1.32f, float(b.random.uniform(-3.8, 3.8))},
              float(b.random.uniform(0.05, 0.15)), b.varied(c(0xb5b09a), 0.2f), 0.3f);
    for (int i = 0; i < 64; ++i) { // the edge
        const float angle = 2 * pi * float(i) / 64;
        const Point at(4.75f * std::cos(angle) + 0.25f * float(b.random.normal()), -0.12f,
                       3.3f * std::sin(angle) + 0.2f * float(b.random.normal()));
        b.dab(stones, at, float(b.random.uniform(0.34, 0.6)), b.varied(c(0x9a958c), 0.15f), 0.4f);
    }
    for (int i = 0; i < 70; ++i) { // moss beyond
        const float angle = 2 * pi * float(i) / 70;
        b.dab(stones,
              {float(b.random.uniform(5.4, 6.7)) * std::cos(angle), -0.22f,
               float(b.random.uniform(3.9, 5.1)) * std::sin(angle)},
              float(b.random.uniform(0.5, 0.8)), b.varied(c(0x6f9050), 0.18f), 0.2f);
    }
}

// A round leaf with a notch, in strokes from its middle.
void paintPad(PaintingBrush &b, LayerId pads, const Point &middle, float radius, float notch)
{
    const Point green = b.varied(c(0x6f9f56), 0.14f);
    const int strokes = 22;
    for (int i = 0; i < strokes; ++i) {
        const float angle = notch + 0.32f + (2 * pi - 0.64f) * float(i) / float(strokes - 1);
        const Point way(std::cos(angle), 0, std::sin(angle));
        b.stroke(pads, StrokeSection::Ellipse,
                 {middle, middle + 0.55f * radius * way, middle + radius * way + Point(0, 0.06f * radius, 0)},
                 {0.02f * radius, 0.11f * radius, 0.16f * radius}, b.varied(green, 0.05f));
    }
}

void paintLily(PaintingBrush &b, LayerId flowers, const Point &middle, float size)
{
    for (int ring = 0; ring < 3; ++ring)
        for (int k = 0; k < 8 - 2 * ring; ++k) {
            const float angle = 2 * pi * (float(k) + 0.5f * float(ring)) / float(8 - 2 * ring);
            const float out = size * (1 - 0.25f * float(ring)), up = size * (0.2f + 0.3f * float(ring));
            const Point way(std::cos(angle), 0, std::sin(angle));
            b.shaded(flowers, StrokeSection::Ellipse,
                     {middle, middle + 0.6f * out * way + Point(0, 0.5f * up, 0),
                      middle + out * way + Point(0, up, 0)},
                     0.17f * size, c(0xf6d7e2), c(ring == 0 ? 0xe79ab8 : 0xf7e9ee));
        }
    b.dab(flowers, middle + Point(0, 0.35f * size, 0), 0.17f * size, c(0xf2c24a), 0.2f);
}

} // namespace

Painting koiPond()
{
    PaintingBrush b(83);
    b.painting.background = c(0x6f9050);
    const LayerId bottom = b.stack("Ground"), stones = b.stack("Stones"), fins = b.stack("Fins"),
                  fish = b.stack("Koi"), heads = b.stack("Eyes and whiskers"), pads = b.stack("Lily pads"),
                  flowers = b.stack("Lilies");
    const LayerId spots = b.layer(fish, "Spots", BlendMode::Normal, 1, 0.05);
    paintPond(b, bottom, stones);

    struct Swimmer
    {
        Bow bow;
        unsigned body, spot;
        double seconds; // a whole round
    };
    const Swimmer swimmers[] = {{{{0.5f, -0.55f, 0.2f}, 1.75f, 2.1f, 1.75f}, 0xf6efe4, 0xe2572b, 12},
                                {{{0.3f, -0.75f, 0.1f}, 1.95f, 5.0f, 1.5f}, 0xf3a24a, 0xf8e9d2, 12},
                                {{{-0.2f, -0.6f, 0.0f}, 2.75f, 0.2f, 1.6f}, 0xf6efe4, 0x2f3240, 12},
                                {{{-0.4f, -0.8f, 0.1f}, 2.6f, 3.75f, 1.35f}, 0xe8b34c, 0xc4472a, 12}};
    std::vector<std::vector<ElementId>> parts;
    for (const Swimmer &swimmer : swimmers)
        parts.push_back(paintFish(b, {fish, spots, fins, heads}, swimmer.bow, swimmer.body, swimmer.spot));

    for (const auto &[place, radius, notch] :
         std::initializer_list<std::tuple<Point, float, float>>{{{-3.2f, 0, -1.5f}, 0.72f, 0.5f},
                                                                {{-2.4f, 0.01f, -2.2f}, 0.5f, 2.6f},
                                                                {{-3.7f, 0.01f, -0.4f}, 0.45f, 5.1f},
                                                                {{3.3f, 0, 1.5f}, 0.62f, 3.6f},
                                                                {{2.5f, 0.01f, 2.15f}, 0.42f, 1.4f}})
        paintPad(b, pads, place, radius, notch);
    paintLily(b, flowers, {-2.75f, 0.08f, -1.75f}, 0.42f);
    paintLily(b, flowers, {3.05f, 0.08f, 1.95f}, 0.34f);

    // Shadows lie on the ground, as copies that swim along.
    const LayerId shadows = b.layer(bottom, "Shadows of the koi", BlendMode::Multiply, 0.55, 0.9);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Element &body = b.at(fish).drawings[0].elements[i];
        Element copy = body;
        copy.id.value = b.painting.nextId++;
        copy.placement.translation += Vec3(0.34, -0.62, 0.24);
        parts[i].push_back(copy.id);
        b.at(shadows).drawings[0].elements.push_back(std::move(copy));
    }
    b.tint(shadows, 0x4f6f7c);
    const LayerId padShadows = b.layer(bottom, "Shadows of the pads", BlendMode::Multiply, 0.5, 1.0);
    b.copies(pads, padShadows, Vec3(0.4, -1.35, 0.28));
    b.tint(padShadows, 0x4f6f7c);
    const LayerId light = b.layer(bottom, "Light through the waves", BlendMode::Screen, 0.42);
    b.everything(light, c(0xf4ffd9));
    NoiseMask noise;
    noise.cellSize = 0.75;
    noise.seed = 12;
    noise.threshold = 0.56;
    noise.softness = 0.1;
    b.at(light).properties.masks = {{true, false, noise}};
    const LayerId backs = b.layer(fish, "Light on the backs", BlendMode::Screen, 0.35);
    const std::size_t copied = b.at(fish).drawings[0].elements.size();
    const std::vector<ElementId> shine = b.copies(fish, backs, Vec3(-0.07, 0.14, -0.05), 0.9);
    DUCTUS_ASSERT(shine.size() == copied);
    b.tint(backs, 0xfff6dc);
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i].push_back(shine[i]);
    const LayerId veins = b.layer(pads, "Sheen of the pads", BlendMode::Screen, 0.3);
    b.copies(pads, veins, Vec3(-0.06, 0.05, -0.06), 0.8);
    b.tint(veins, 0xe6f5a8);
    const LayerId water = b.sceneLayer("Water", BlendMode::Normal, 0.7);
    b.everything(water, c(0x2f6f7f));
    b.at(water).properties.masks = {
        {true, false,
         GradientMask{
             GradientMask::Shape::Linear, {0, -0.25, 0}, {0, -1.7, 0}, 0, 0.85, MaskEasing::Linear}}};

    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::vector<PlacementKey> keys;
        for (int k = 0; k <= 16; ++k) {
            PlacementKey key;
            key.timeSeconds = swimmers[i].seconds * k / 16;
            key.placement.rotation =
                Eigen::AngleAxisd(2 * std::numbers::pi * k / 16, Eigen::Vector3d::UnitY());
            const Vec3 middle = swimmers[i].bow.middle.cast<double>();
            key.placement.translation = middle - key.placement.rotation * middle;
            keys.push_back(key);
        }
        b.addGroup("Koi " + std::to_string(i + 1), parts[i], keys);
    }
    b.painting.loopSeconds = 12;
    b.keepLook("Morning");
    b.at(water).properties.opacity = 0.95;
    b.tint(water, 0x2a4f5a);
    b.at(light).properties.opacity = 0.12;
    b.keepLook("Overcast");
    for (const auto &[id, properties] : b.painting.looks[0].layers)
        b.at(id).properties = properties;
    b.camera({0.4, 8.2, 4.6}, {0, -0.4, 0.1}, 38);
    return b.painting;
}

} // namespace ductus
