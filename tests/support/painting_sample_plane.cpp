// A plane over clouds and fields whose shadow goes along (Fig. V.9).
#include "support/painting_brush.h"
#include "support/painting_samples.h"

#include <cmath>

namespace ductus {

namespace {

using Point = PaintingBrush::Point;

void paintFields(PaintingBrush &b, LayerId fields)
{
    const unsigned colours[] = {0x8db255, 0xb9c45f, 0xd9c274, 0x6f9c55, 0xa7b862, 0xc8a65a, 0x7fae6a};
    for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 9; ++column) {
            const Point middle(-14.f + 3.5f * float(column) + 0.8f * float(row % 2), -4,
                               6 - 3.2f * float(row));
            const Point field = b.varied(PaintingBrush::colour(colours[b.random.index(7)]), 0.08f);
            const bool across = b.random.index(2) == 0;
            for (int k = 0; k < 3; ++k) { // furrows
                const float side = -1.05f + 1.05f * float(k);
                const Point from = middle + (across ? Point(-1.65f, 0, side) : Point(1.1f * side, 0, -1.5f));
                const Point to = middle + (across ? Point(1.65f, 0, side) : Point(1.1f * side, 0, 1.5f));
                b.stroke(fields, StrokeSection::Ellipse, {from, 0.5f * (from + to), to}, {0.6f},
                         b.varied(field, 0.05f));
            }
        }
    for (int strip = 0; strip < 10; ++strip) { // hedges and lanes show between the fields
        const float z = 8 - 2.6f * float(strip);
        b.stroke(fields, StrokeSection::Ellipse,
                 {Point(-20, -4.35f, z), Point(0, -4.35f, z), Point(20, -4.35f, z)}, {1.5f},
                 b.varied(PaintingBrush::colour(0x86a860), 0.06f));
    }
    std::vector<Point> river;
    for (float z = 9; z > -16; z -= 1)
        river.push_back({3 * std::sin(0.35f * z) - 2, -3.8f, z});
    b.stroke(fields, StrokeSection::Ellipse, river, {0.45f}, PaintingBrush::colour(0x79b4d6));
    for (int i = 0; i < 46; ++i) // trees far below
        b.dab(fields, {float(b.random.uniform(-13, 13)), -3.75f, float(b.random.uniform(-13, 6))},
              float(b.random.uniform(0.14, 0.3)), b.varied(PaintingBrush::colour(0x4d7f4d), 0.15f));
}

void paintCloud(PaintingBrush &b, LayerId clouds, const Point &middle, float size)
{
    const int dabs = 9;
    for (int i = 0; i < dabs; ++i) {
        const float t = float(i) / float(dabs - 1) * 2 - 1;
        b.dab(clouds,
              middle + size * Point(1.35f * t, 0.34f * (1 - t * t) * float(b.random.uniform(0.3, 1.2)),
                                    0.35f * float(b.random.uniform(-1, 1))),
              size * (0.3f + 0.3f * (1 - t * t)) * float(b.random.uniform(0.85, 1.1)),
              b.varied(PaintingBrush::colour(0xf4f6fb), 0.02f), 0.4f);
    }
}

void paintPlane(PaintingBrush &b, LayerId plane)
{
    const Point red = PaintingBrush::colour(0xd9503f), cream = PaintingBrush::colour(0xf2e3c6);
    // Flies along +x.
    b.stroke(plane, StrokeSection::Round,
             {Point(-1.55f, 0.22f, 0), Point(-0.9f, 0.1f, 0), Point(0, 0, 0), Point(0.7f, 0, 0),
              Point(1.15f, 0.02f, 0)},
             {0.07f, 0.17f, 0.29f, 0.3f, 0.2f}, red);
    b.stroke(plane, StrokeSection::Round, {Point(1.1f, 0.02f, 0), Point(1.32f, 0.02f, 0)}, {0.2f, 0.1f},
             cream);
    for (const float side : {-1.f, 1.f}) {
        b.stroke(plane, StrokeSection::Ellipse,
                 {Point(0.35f, 0.02f, 0.15f * side), Point(0.28f, 0.1f, 1.1f * side),
                  Point(0.15f, 0.2f, 2.0f * side)},
                 {0.36f, 0.3f, 0.2f}, cream);
        b.stroke(plane, StrokeSection::Ellipse,
                 {Point(-1.4f, 0.24f, 0.05f * side), Point(-1.5f, 0.28f, 0.65f * side)}, {0.2f, 0.12f},
                 cream);
        b.stroke(plane, StrokeSection::Round,
                 {Point(0.3f, 0.1f, 1.05f * side), Point(0.72f, 0.1f, 1.05f * side)}, {0.12f, 0.09f}, red);
        for (int i = 0; i < 4; ++i) {
            const float x = -0.45f + 0.3f * float(i);
            b.stroke(plane, StrokeSection::Round,
                     {Point(x, 0.13f, 0.24f * side), Point(x + 0.1f, 0.13f, 0.245f * side)}, {0.06f},
                     PaintingBrush::colour(0x5d7f9e));
        }
    }
    b.stroke(plane, StrokeSection::Ellipse,
             {Point(-1.35f, 0.25f, 0), Point(-1.55f, 0.55f, 0), Point(-1.68f, 0.78f, 0)},
             {0.24f, 0.18f, 0.1f}, red, Point::UnitZ());
    b.stroke(plane, StrokeSection::Round, {Point(0.62f, 0.22f, 0), Point(0.86f, 0.15f, 0)}, {0.17f, 0.12f},
             PaintingBrush::colour(0x4b6a88));
    b.stroke(plane, StrokeSection::Ellipse,
             {Point(1.36f, -0.5f, 0.05f), Point(1.36f, 0.02f, 0), Point(1.36f, 0.54f, -0.05f)}, {0.05f},
             PaintingBrush::colour(0x5a4a44), Point::UnitX());
}

// Strokes pressed flat onto a height, as a shadow that is copied and pushed down.
std::vector<ElementId> shadowOf(PaintingBrush &b, LayerId from, LayerId to, const Vec3 &shift, double scale)
{
    const std::size_t first = b.at(to).drawings[0].elements.size();
    b.copies(from, to, shift);
    std::vector<ElementId> ids;
    for (std::size_t i = first; i < b.at(to).drawings[0].elements.size(); ++i) {
        Element &element = b.at(to).drawings[0].elements[i];
        Placement spread;
        spread.scale = scale;
        spread.translation = (1 - scale) * shift;
        element.placement = spread * element.placement;
        ids.push_back(element.id);
    }
    return ids;
}

} // namespace

Painting planeOverClouds()
{
    PaintingBrush b(23);
    b.painting.background = PaintingBrush::colour(0xa9d3ea);
    const LayerId fields = b.stack("Fields"), clouds = b.stack("Clouds"), trails = b.stack("Trails"),
                  plane = b.stack("Plane");
    paintFields(b, fields);
    const std::pair<Point, float> places[] = {{{-4.5f, -2, -1}, 1.5f},      {{4.2f, -1.9f, -3}, 1.7f},
                                              {{0.4f, -2.2f, -7}, 1.9f},    {{-7.5f, -2, -7.5f}, 2.1f},
                                              {{8, -2, -8}, 2.0f},          {{2.6f, -2.3f, 1.6f}, 1.1f},
                                              {{-8.5f, -2.2f, 2.5f}, 1.3f}, {{-2, -2, -11.5f}, 2.3f}};
    for (const auto &[place, size] : places)
        paintCloud(b, clouds, place, size);
    paintPlane(b, plane);
    for (const float side : {-1.f, 1.f})
        b.stroke(
            trails, StrokeSection::Round,
            {Point(-0.2f, 0.1f, 1.05f * side), Point(-3, 0.1f, 1.05f * side), Point(-9, 0.06f, 1.05f * side)},
            {0.05f, 0.045f, 0.01f}, PaintingBrush::colour(0xffffff));

    const LayerId light = b.layer(plane, "Sun on the plane", BlendMode::Screen, 0.55);
    b.copies(plane, light, Vec3(0.05, 0.17, 0.08));
    b.tint(light, 0xffe2a8);
    const LayerId dark = b.layer(plane, "Shade below", BlendMode::Multiply, 0.6);
    b.copies(plane, dark, Vec3(-0.03, -0.2, -0.05));
    b.tint(dark, 0x8b7fb0);
    const LayerId cloudShade = b.layer(clouds, "Shade of the clouds", BlendMode::Multiply, 0.75);
    b.copies(clouds, cloudShade, Vec3(-0.12, -0.3, -0.05), 1.02);
    b.tint(cloudShade, 0xb9c3e4);
    const LayerId cloudLight = b.layer(clouds, "Sun on the clouds", BlendMode::Normal, 0.8);
    b.copies(clouds, cloudLight, Vec3(0.12, 0.25, 0.1), 0.8);
    b.tint(cloudLight, 0xfffaf0);
    const LayerId cloudShadows = b.layer(fields, "Shadows of the clouds", BlendMode::Multiply, 0.5, 0.9);
    b.copies(clouds, cloudShadows, Vec3(-0.9, -1.9, -0.4), 1.05);
    b.tint(cloudShadows, 0x7f93b5);
    const LayerId onFields = b.layer(fields, "Shadow of the plane", BlendMode::Multiply, 0.6, 0.7);
    const auto below = shadowOf(b, plane, onFields, Vec3(-1.4, -3.8, -0.9), 1);
    b.tint(onFields, 0x5f6f96);
    const LayerId onClouds = b.layer(clouds, "Shadow on the clouds", BlendMode::Multiply, 0.55, 1.0);
    const auto above = shadowOf(b, plane, onClouds, Vec3(-0.9, -1.6, -0.5), 1);
    b.tint(onClouds, 0x8f95c4);
    const LayerId air = b.sceneLayer("Air", BlendMode::Normal, 0.75);
    b.everything(air, PaintingBrush::colour(0xcfe6f2));
    b.at(air).properties.masks = {
        {true, false,
         GradientMask{GradientMask::Shape::Linear, {0, 0, 3}, {0, 0, -15}, 0, 0.9, MaskEasing::Smooth}}};

    // Everything of the plane flies as one: itself, its light, its shadows, its trails.
    std::vector<ElementId> flying = below;
    flying.insert(flying.end(), above.begin(), above.end());
    for (const LayerId id : {plane, light, dark, trails})
        for (const Element &element : b.at(id).drawings[0].elements)
            flying.push_back(element.id);
    const auto key = [](double time, double x) {
        PlacementKey made;
        made.timeSeconds = time;
        made.placement.translation = {x, 0.12 * std::sin(2 * time), 0};
        return made;
    };
    b.addGroup("Plane", flying, {key(0, -1.7), key(2, 0.4), key(4, 2.5), key(6, 4.6)});
    b.painting.loopSeconds = 6;
    b.keepLook("Noon");
    b.camera({-0.6, 4.0, 8.6}, {-0.2, -1.2, -1}, 44);
    return b.painting;
}

} // namespace ductus
