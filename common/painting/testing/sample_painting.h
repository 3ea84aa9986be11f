// A painting that uses everything a painting can hold, for tests.
#pragma once

#include "base/random.h"
#include "painting/scene/painting.h"

namespace ductus {

inline std::shared_ptr<const ElementShape> sampleStroke(Random &random, int points, StrokeSection section)
{
    StrokeShape stroke;
    stroke.section = section;
    Eigen::Vector3f position(float(random.uniform(-2, 2)), float(random.uniform(0, 2)),
                             float(random.uniform(-2, 2)));
    for (int i = 0; i < points; ++i) {
        position += 0.05f * Eigen::Vector3f(float(random.normal()), float(random.normal()), 1.f);
        stroke.points.push_back({position,
                                 Eigen::Vector3f(float(random.normal()), 1.f, 0.25f).normalized(),
                                 float(random.uniform(0, 0.1)),
                                 {float(random.uniform()), float(random.uniform()), float(random.uniform())},
                                 float(random.uniform())});
    }
    return std::make_shared<const ElementShape>(std::move(stroke));
}

inline Placement samplePlacement(Random &random)
{
    Placement placement;
    placement.rotation =
        Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), 2).normalized();
    placement.scale = random.uniform(0.1, 3);
    placement.mirrored = random.index(2) == 0;
    placement.translation = {random.normal(), random.normal(), 1.0 / 3.0};
    return placement;
}

/// \a strokes in each of the two substrates.
inline Painting samplePainting(std::uint64_t seed, int strokes = 5, int points = 7)
{
    Random random(seed);
    Painting painting;
    const auto id = [&] { return painting.nextId++; };
    const auto layer = [&](const char *name) {
        Layer made;
        made.id.value = id();
        made.name = name;
        return made;
    };
    for (const char *name : {"Arbre \xc3\xa9t\xc3\xa9", "\xe6\x9c\xa8"}) {
        Stack stack;
        stack.id.value = id();
        stack.name = name;
        stack.substrate = layer(name);
        for (int i = 0; i < strokes; ++i)
            stack.substrate->drawings[0].elements.push_back(
                {ElementId{id()}, i % 2 ? samplePlacement(random) : Placement(),
                 sampleStroke(random, points, StrokeSection(random.index(4)))});
        painting.stacks.push_back(std::move(stack));
    }
    Stack &tree = painting.stacks[0];
    Layer shade = layer("shade");
    shade.locked = true;
    shade.properties.opacity = 0.1 + 0.2; // not a short decimal
    shade.properties.blendMode = BlendMode::ColourDodge;
    shade.properties.colour = Eigen::Vector3f(0.1f, 0.2f, 0.7f);
    shade.tolerance = 0.0625;
    shade.toleranceMode = ToleranceMode::View;
    shade.properties.masks = {
        {true, true,
         GradientMask{GradientMask::Shape::Spherical, {0, 1, 2}, {3, 4, 5}, 0.25, 0.75, MaskEasing::Smooth}},
        {false, false, NoiseMask{0.5, 18446744073709551615ull, 0.4, 0.3, 0.2, 0.9}},
        {true, false,
         TextureMask{samplePlacement(random), 2, 1, 3,
                     std::make_shared<const std::vector<std::uint8_t>>(
                         std::vector<std::uint8_t>{0, 1, 127, 128, 254, 255})}},
        {true, true, StrokeMask{tree.substrate->id, false}}};
    // A duplicate: the shape is shared with the substrate.
    shade.drawings[0].elements.push_back(
        {ElementId{id()}, samplePlacement(random), tree.substrate->drawings[0].elements[0].shape});
    shade.motion = {{-1, samplePlacement(random), KeyInterpolation::Hold},
                    {2.5, samplePlacement(random), KeyInterpolation::Smooth}};
    tree.appearance.push_back(std::move(shade));

    Layer frames = layer("frames");
    frames.drawings.resize(3); // the middle one is empty
    for (const std::size_t drawing : {0u, 2u})
        frames.drawings[drawing].elements.push_back(
            {ElementId{id()}, {}, sampleStroke(random, 4, StrokeSection::Ribbon)});
    frames.frames = {12.5, 3, {0, 1, 1, 2, 0}};
    painting.stacks[1].appearance.push_back(std::move(frames));

    Layer light = layer("light");
    MeshShape mesh;
    mesh.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.0 / 3.0}};
    mesh.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    mesh.vertexColours = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1f, 0.1f, 0.1f}};
    light.drawings[0].elements.push_back({ElementId{id()}, {}, std::make_shared<const ElementShape>(mesh)});
    painting.sceneStack.appearance.push_back(std::move(light));

    painting.blendSpace = BlendSpace::Linear;
    painting.background = {0.2f, 0.3f, 0.4f};
    painting.metresPerUnit = 0.01;
    painting.loopSeconds = 4;
    for (const char *name : {"day", "night"}) {
        Look look{LookId{id()}, name, {}};
        for (const Layer *each : painting.layers())
            look.layers.emplace_back(each->id, each->properties);
        painting.looks.push_back(std::move(look));
    }
    painting.looks[1].layers[1].second.opacity = 0.5;
    painting.motionGroups = {{MotionGroupId{id()},
                              "plane",
                              {tree.substrate->drawings[0].elements[0].id},
                              {{0, {}, {}}, {4, samplePlacement(random), KeyInterpolation::Smooth}}}};
    CameraKey key;
    key.eye = {0, 1, 5};
    key.rotation = samplePlacement(random).rotation;
    key.verticalViewDegrees = 33.3;
    painting.camera.keys = {key};
    key.timeSeconds = 4;
    key.interpolation = KeyInterpolation::Linear;
    painting.camera.keys.push_back(key);
    Image image(3, 2, {10, 20, 30, 40});
    image.set(2, 1, {255, 0, 255, 0});
    painting.pictures = {{PictureId{id()}, "target", false, 0.5, samplePlacement(random),
                          std::make_shared<const Image>(image)}};
    return painting;
}

} // namespace ductus
