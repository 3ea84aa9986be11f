#include "support/painting_scenes.h"

#include "base/random.h"

#include <cmath>
#include <numbers>

namespace ductus {

namespace {

using Colour = Eigen::Vector3f;
using Point = Eigen::Vector3f;

const Colour paper(0.85f, 0.8f, 0.7f), blue(0.1f, 0.25f, 0.8f), red(0.8f, 0.08f, 0.05f),
    green(0.1f, 0.55f, 0.15f), purple(0.35f, 0.05f, 0.5f), yellow(0.95f, 0.75f, 0.1f),
    dark(0.02f, 0.02f, 0.04f);

FrameCamera cameraAt(const Vec3 &eye, const Vec3 &target = Vec3::Zero())
{
    return FrameCamera::lookingAt(eye, target, 40, 4.0 / 3, Vec3::UnitY());
}

PaintingScene scene(std::string name, PaintingBuilder &&builder, const FrameCamera &camera)
{
    return {std::move(name), std::move(builder.painting), camera, {}};
}

int addPlate(PaintingBuilder &builder)
{
    const int stack = builder.addStack("Plate");
    builder.add(builder.substrate(stack), boxMesh({-1, -0.75, -0.2}, {1, 0.75, 0}, paper));
    return stack;
}

int addBumps(PaintingBuilder &builder)
{
    const int stack = builder.addStack("Bumps");
    for (int i = -5; i <= 5; ++i) {
        const float x = 0.15f * float(i);
        builder.add(builder.substrate(stack),
                    evenStroke(StrokeSection::Round, {{x, -0.75f, -0.1f}, {x, 0.75f, -0.1f}}, 0.1f,
                               i % 2 ? paper : Colour(0.9f * paper)));
    }
    return stack;
}

/// Wavy, along x.
std::vector<Point> wave(float y, float z, float height, int count = 24)
{
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        const float t = float(i) / float(count - 1);
        points.push_back({-0.8f + 1.6f * t, y + height * std::sin(7 * t), z});
    }
    return points;
}

FrameCamera toleranceView(int view)
{
    switch (view) {
    case 1:
        return cameraAt({1.8, 0, 1.8});
    case 2:
        return cameraAt({0, -1.8, 1.8});
    case 3:
        return cameraAt({-1.5, 1.2, 1.5});
    case 4:
        return cameraAt({0.5, -2.4, 0.8});
    case 5:
        return cameraAt({-0.032, -1.2, 1.9}, {-0.032, 0, 0});
    case 6:
        return cameraAt({0.032, -1.2, 1.9}, {0.032, 0, 0});
    default:
        return cameraAt({0, 0, 2.6});
    }
}

PaintingScene toleranceScene(const std::string &name, int view, bool bumpy)
{
    PaintingBuilder builder;
    const int stack = bumpy ? addBumps(builder) : addPlate(builder);
    Layer &layer = builder.addLayer(stack, "Mark");
    layer.tolerance = 0.08;
    std::vector<Point> points;
    for (int i = 0; i <= 24; ++i)
        points.push_back({-0.7f + 1.4f * float(i) / 24, 0, 0.05f});
    builder.add(layer, evenStroke(StrokeSection::Round, points, 0.1f, red));
    return scene(name + "-" + std::to_string(view), std::move(builder), toleranceView(view));
}

} // namespace

int PaintingBuilder::addStack(const std::string &name)
{
    Stack stack;
    stack.id = StackId{painting.nextId++};
    stack.name = name;
    stack.substrate.emplace();
    stack.substrate->id = LayerId{painting.nextId++};
    stack.substrate->name = name;
    painting.stacks.push_back(std::move(stack));
    return int(painting.stacks.size()) - 1;
}

Layer &PaintingBuilder::addLayer(int stack, const std::string &name)
{
    Layer layer;
    layer.id = LayerId{painting.nextId++};
    layer.name = name;
    auto &layers = (stack < 0 ? painting.sceneStack : painting.stacks[std::size_t(stack)]).appearance;
    layers.push_back(std::move(layer));
    return layers.back();
}

ElementId PaintingBuilder::add(Layer &layer, ElementShape shape, const Placement &placement)
{
    const ElementId id{painting.nextId++};
    layer.drawings.front().elements.push_back(
        {id, placement, std::make_shared<const ElementShape>(std::move(shape))});
    return id;
}

LookId PaintingBuilder::addLook(const std::string &name)
{
    const LookId id{painting.nextId++};
    painting.looks.push_back({id, name, {}});
    return id;
}

MotionGroupId PaintingBuilder::addGroup(const std::string &name, std::vector<ElementId> elements,
                                        std::vector<PlacementKey> keys)
{
    const MotionGroupId id{painting.nextId++};
    painting.motionGroups.push_back({id, name, std::move(elements), std::move(keys)});
    return id;
}

StrokeShape evenStroke(StrokeSection section, const std::vector<Eigen::Vector3f> &points, float halfWidth,
                       const Eigen::Vector3f &colour, float opacity, const Eigen::Vector3f &normal)
{
    StrokeShape stroke;
    stroke.section = section;
    for (const Point &point : points)
        stroke.points.push_back({point, normal, halfWidth, colour, opacity});
    return stroke;
}

MeshShape boxMesh(const Vec3 &min, const Vec3 &max, const Eigen::Vector3f &colour)
{
    MeshShape shape;
    for (int i = 0; i < 8; ++i)
        shape.mesh.vertices.push_back(
            {i & 1 ? max[0] : min[0], i & 2 ? max[1] : min[1], i & 4 ? max[2] : min[2]});
    shape.mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                            {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    shape.vertexColours.assign(8, colour);
    return shape;
}

MeshShape ballMesh(const Vec3 &centre, double radius, const Eigen::Vector3f &colour)
{
    MeshShape shape;
    const int rings = 16, sides = 24;
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < sides; ++j) {
            const double a = std::numbers::pi * i / rings, b = 2 * std::numbers::pi * j / sides;
            shape.mesh.vertices.push_back(
                centre + radius * Vec3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)));
        }
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sides; ++j) {
            const int p = i * sides + j, q = i * sides + (j + 1) % sides;
            if (i > 0)
                shape.mesh.triangles.push_back({p, p + sides, q});
            if (i + 1 < rings)
                shape.mesh.triangles.push_back({q, p + sides, q + sides});
        }
    shape.vertexColours.assign(shape.mesh.vertices.size(), colour);
    return shape;
}

PaintingScene intersectionFromOutside()
{
    PaintingBuilder builder;
    const int stack = builder.addStack("Tube");
    builder.add(builder.substrate(stack), evenStroke(StrokeSection::Round, wave(0, 0, 0.2f), 0.3f, paper));
    const int other = builder.addStack("Other tube, not to be coloured");
    builder.add(builder.substrate(other),
                evenStroke(StrokeSection::Round, {{-0.4f, -0.6f, 0.2f}, {-0.4f, 0.6f, 0.2f}}, 0.12f, green));
    Layer &layer = builder.addLayer(stack, "Coat");
    builder.add(layer,
                evenStroke(StrokeSection::Round, {{-0.5f, 0.5f, 0.2f}, {0.6f, -0.4f, 0.2f}}, 0.25f, blue));
    return scene("intersection-from-outside", std::move(builder), cameraAt({0.4, -0.5, 2.8}));
}

PaintingScene cameraInsideAStroke()
{
    PaintingBuilder builder;
    const int stack = builder.addStack("Things");
    for (int i = -2; i <= 2; ++i)
        builder.add(builder.substrate(stack),
                    evenStroke(StrokeSection::Round,
                               {{0.35f * float(i), -0.4f, 0}, {0.35f * float(i), 0.4f, 0.1f * float(i)}},
                               0.12f, i % 2 ? paper : green));
    Layer &layer = builder.addLayer(-1, "Dusk");
    layer.properties.blendMode = BlendMode::Multiply;
    // Taller than everything, ending in the middle of the picture.
    builder.add(layer, evenStroke(StrokeSection::Round, {{-20, 0, 0}, {-4.8f, 0, 0}}, 5.2f, purple));
    return scene("camera-inside-a-stroke", std::move(builder), cameraAt({-0.3, -0.5, 2.2}));
}

PaintingScene selfOverlap()
{
    PaintingBuilder builder;
    const int stack = addPlate(builder);
    Layer &layer = builder.addLayer(stack, "Loop");
    std::vector<Point> loop;
    for (int i = 0; i <= 40; ++i) {
        const float t = -2.2f + 4.4f * float(i) / 40;
        loop.push_back({0.9f * t / 2.2f - 0.9f * std::sin(1.6f * t) * 0.6f, 0.5f * std::cos(1.6f * t), 0});
    }
    builder.add(layer, evenStroke(StrokeSection::Round, loop, 0.1f, blue, 0.5f));
    return scene("self-overlap", std::move(builder), cameraAt({0, 0, 2.6}));
}

PaintingScene strokeOrder()
{
    PaintingBuilder builder;
    const int stack = addPlate(builder);
    Layer &layer = builder.addLayer(stack, "Strokes");
    builder.add(layer,
                evenStroke(StrokeSection::Round, {{-0.7f, -0.2f, 0}, {0.7f, -0.2f, 0}}, 0.12f, blue, 0.6f));
    builder.add(layer,
                evenStroke(StrokeSection::Round, {{-0.4f, -0.6f, 0}, {-0.4f, 0.6f, 0}}, 0.12f, red, 0.6f));
    builder.add(layer,
                evenStroke(StrokeSection::Cube, {{-0.7f, 0.3f, 0}, {0.7f, 0.3f, 0}}, 0.12f, green, 0.6f));
    builder.add(layer,
                evenStroke(StrokeSection::Ellipse, {{0.4f, -0.6f, 0}, {0.4f, 0.6f, 0}}, 0.12f, yellow, 1));
    return scene("stroke-order", std::move(builder), cameraAt({0, -0.6, 2.6}));
}

/// Opaque strokes over each other in layers that are not: of each only the topmost one shows.
PaintingScene opaqueStrokesInClearLayers()
{
    PaintingBuilder builder;
    const int stack = addPlate(builder);
    int number = 0;
    for (const auto &[mode, opacity] :
         {std::pair(BlendMode::Normal, 0.5), std::pair(BlendMode::Multiply, 0.8),
          std::pair(BlendMode::Screen, 0.6), std::pair(BlendMode::Multiply, 1.0)}) {
        Layer &layer = builder.addLayer(stack, "Layer " + std::to_string(number));
        layer.properties.blendMode = mode;
        layer.properties.opacity = opacity;
        const float y = -0.5f + 0.3f * float(number++);
        builder.add(layer, evenStroke(StrokeSection::Round, {{-0.8f, y, 0}, {0.8f, y, 0}}, 0.14f, blue));
        builder.add(
            layer, evenStroke(StrokeSection::Round, {{-0.5f, y - 0.3f, 0}, {-0.3f, y + 0.3f, 0}}, 0.1f, red));
        builder.add(layer, evenStroke(StrokeSection::Cube, wave(y + 0.05f, 0, 0.15f), 0.06f, yellow));
        builder.add(layer,
                    evenStroke(StrokeSection::Round, {{0.2f, y - 0.3f, 0}, {0.5f, y + 0.3f, 0}}, 0.1f, dark));
    }
    return scene("opaque-strokes-in-clear-layers", std::move(builder), cameraAt({0, -0.6, 2.4}));
}

PaintingScene toleranceOnFlat(int view)
{
    return toleranceScene("tolerance-on-flat", view, false);
}

PaintingScene toleranceOnBumps(int view)
{
    return toleranceScene("tolerance-on-bumps", view, true);
}

PaintingScene toleranceReach()
{
    PaintingBuilder builder;
    const int stack = addPlate(builder);
    Layer &layer = builder.addLayer(stack, "Ribbons");
    layer.tolerance = 0.08;
    for (const auto &[y, z] : {std::pair{0.5f, 0.02f}, {0.f, 0.06f}, {-0.5f, 0.1f}})
        builder.add(layer,
                    evenStroke(StrokeSection::Ribbon, {{-0.8f, y, z}, {0, y, z}, {0.8f, y, z}}, 0.1f, red));
    return scene("tolerance-reach", std::move(builder), cameraAt({0, -1.2, 2.2}));
}

PaintingScene toleranceOfView()
{
    PaintingScene made = toleranceScene("tolerance-of-view", 2, true);
    made.painting.stacks[0].appearance[0].toleranceMode = ToleranceMode::View;
    return made;
}

PaintingScene allSections()
{
    PaintingBuilder builder;
    const int stack = builder.addStack("Sections");
    const int coloured = builder.addStack("Coloured");
    Layer &layer = builder.addLayer(coloured, "Bands");
    layer.tolerance = 0.05;
    for (int k = 0; k < 4; ++k)
        for (int side = 0; side < 2; ++side) {
            StrokeShape stroke;
            stroke.section = StrokeSection(k);
            const int count = 12;
            for (int i = 0; i < count; ++i) {
                const float t = float(i) / float(count - 1), turn = 2.5f * t;
                const float y = 0.6f - 0.4f * float(k), x = (side ? 0.1f : -0.9f) + 0.8f * t;
                stroke.points.push_back({{x, y + 0.08f * std::sin(9 * t), 0.1f * std::cos(5 * t)},
                                         {0, std::sin(turn), std::cos(turn)},
                                         (i == 0 || i == count - 1) && side ? 0.f : 0.12f,
                                         (1 - t) * blue + t * yellow});
            }
            builder.add(builder.substrate(side ? coloured : stack), stroke);
        }
    for (int k = 0; k < 4; ++k)
        builder.add(layer, evenStroke(StrokeSection(k),
                                      {{0.3f + 0.12f * float(k), -0.9f, 0.05f},
                                       {0.3f + 0.12f * float(k), 0.9f, 0.05f}},
                                      0.05f, red, 0.8f));
    return scene("all-sections", std::move(builder), cameraAt({0.3, -0.8, 2.5}));
}

PaintingScene mirroredElements()
{
    PaintingBuilder builder;
    const int stack = builder.addStack("Mirrored");
    Placement mirror;
    mirror.mirrored = true;
    mirror.scale = 0.8;
    mirror.rotation = Eigen::AngleAxisd(0.2, Vec3::UnitZ());
    const auto both = [&](Layer &layer, const ElementShape &shape) {
        Placement plain = mirror;
        plain.mirrored = false;
        plain.rotation = plain.rotation.conjugate(); // the mirror image of the other in the plane x = 0
        builder.add(layer, shape, mirror);
        builder.add(layer, shape, plain);
    };
    StrokeShape tube =
        evenStroke(StrokeSection::Ellipse, {{0.3f, -0.5f, 0}, {0.5f, 0, 0.2f}, {0.9f, 0.5f, 0}}, 0.2f, paper,
                   1, {0.3f, 0.2f, 1});
    both(builder.substrate(stack), tube);
    both(builder.substrate(stack), ballMesh({0.5, -0.1, -0.4}, 0.35, green));
    Layer &layer = builder.addLayer(stack, "Coat");
    layer.tolerance = 0.03;
    both(layer, ballMesh({0.45, 0.1, 0}, 0.3, blue));
    both(layer, evenStroke(StrokeSection::Cube, {{0.2f, -0.3f, 0.1f}, {1, -0.2f, 0}}, 0.1f, red, 0.7f));
    return scene("mirrored-elements", std::move(builder), cameraAt({0, 0, 2.8}));
}

PaintingScene hiddenLayers()
{
    PaintingScene made = strokeOrder();
    made.name = "hidden-layers";
    PaintingBuilder builder;
    builder.painting = std::move(made.painting);
    Layer &hidden = builder.addLayer(0, "Hidden");
    hidden.properties.visible = false;
    builder.add(hidden, evenStroke(StrokeSection::Cube, {{-0.9f, 0, 0}, {0.9f, 0, 0}}, 0.6f, dark));
    Layer &clear = builder.addLayer(0, "Without opacity");
    clear.properties.opacity = 0;
    builder.add(clear, evenStroke(StrokeSection::Cube, {{-0.9f, 0, 0}, {0.9f, 0, 0}}, 0.6f, dark));
    const int stack = builder.addStack("Hidden stack");
    builder.substrate(stack).properties.visible = false;
    builder.add(builder.substrate(stack), boxMesh({-0.5, -0.5, 0.2}, {0.5, 0.5, 0.4}, dark));
    Layer &coat = builder.addLayer(stack, "Coat of the hidden one");
    builder.add(coat, evenStroke(StrokeSection::Cube, {{-0.9f, 0, 0}, {0.9f, 0, 0}}, 0.6f, dark));
    made.painting = std::move(builder.painting);
    return made;
}

PaintingScene twoHundredStacks()
{
    PaintingBuilder builder;
    for (int i = 0; i < 200; ++i) {
        const float x = -0.95f + 0.1f * float(i % 20), y = -0.65f + 0.14f * float(i / 20);
        const int stack = builder.addStack("Dot " + std::to_string(i));
        builder.add(builder.substrate(stack), evenStroke(StrokeSection::Round, {{x, y, 0}}, 0.045f, paper));
        Layer &layer = builder.addLayer(stack, "Coat " + std::to_string(i));
        // Each stroke runs across all dots of its row but may colour one only.
        builder.add(layer, evenStroke(StrokeSection::Round, {{-1, y, 0.03f}, {1, y, 0.03f}}, 0.03f,
                                      {float(i % 20) / 20, float(i / 20) / 10, 0.5f}));
    }
    return scene("two-hundred-stacks", std::move(builder), cameraAt({0, 0, 2.4}));
}

PaintingScene masked(const std::string &mask)
{
    PaintingBuilder builder;
    const int stack = addPlate(builder);
    Layer &shape = builder.addLayer(stack, "Shape of the mask");
    shape.properties.visible = false;
    builder.add(shape, evenStroke(StrokeSection::Round, wave(0, 0, 0.3f), 0.15f, dark));
    const LayerId shapeId = shape.id;
    Layer &layer = builder.addLayer(stack, "Coat");
    builder.add(layer, evenStroke(StrokeSection::Cube, {{-0.9f, 0, 0}, {0.9f, 0, 0}}, 0.6f, blue));
    GradientMask linear;
    linear.start = {-0.6, -0.2, 0};
    linear.end = {0.6, 0.2, 0};
    GradientMask spherical;
    spherical.shape = GradientMask::Shape::Spherical;
    spherical.start = {0.2, 0.1, 0};
    spherical.end = {0.2, 0.6, 0};
    spherical.easing = MaskEasing::Smooth;
    NoiseMask noise;
    noise.cellSize = 0.12;
    noise.seed = 0x123456789abcULL;
    noise.softness = 0.2;
    TextureMask texture;
    texture.width = 5;
    texture.height = 4;
    texture.depth = 3;
    auto values = std::make_shared<std::vector<std::uint8_t>>();
    Random random(4);
    for (int i = 0; i < 60; ++i)
        values->push_back(std::uint8_t(random.index(256)));
    texture.values = values;
    texture.placement.translation = {-0.6, -0.6, -0.6};
    texture.placement.scale = 1.2;
    auto &masks = layer.properties.masks;
    if (mask == "linear")
        masks.push_back({true, false, linear});
    else if (mask == "spherical")
        masks.push_back({true, false, spherical});
    else if (mask == "noise")
        masks.push_back({true, false, noise});
    else if (mask == "texture")
        masks.push_back({true, false, texture});
    else if (mask == "two")
        masks = {{true, true, spherical}, {true, false, linear}, {false, false, noise}};
    else
        masks.push_back({true, false, StrokeMask{shapeId, mask == "stroke-inside"}});
    return scene("mask-" + mask, std::move(builder), cameraAt({0, -0.5, 2.3}));
}

PaintingScene blended(BlendMode mode, BlendSpace space)
{
    PaintingBuilder builder;
    builder.painting.blendSpace = space;
    const int stack = builder.addStack("Columns");
    for (int i = 0; i < 10; ++i) {
        const float x = -0.9f + 0.2f * float(i), t = float(i) / 6;
        const Colour colour = i < 7 ? Colour(t, t, t) : i == 7 ? red : i == 8 ? green : blue;
        builder.add(builder.substrate(stack), boxMesh({x - 0.1, -0.75, -0.2}, {x + 0.1, 0.75, 0}, colour));
    }
    Layer &layer = builder.addLayer(stack, "Bars");
    layer.properties.blendMode = mode;
    layer.properties.opacity = 0.9;
    const std::array<Colour, 6> bars{Colour(0, 0, 0), Colour(0.5f, 0.5f, 0.5f), Colour(1, 1, 1), red, yellow,
                                     purple};
    for (int k = 0; k < 6; ++k) {
        const float y = -0.6f + 0.24f * float(k);
        builder.add(layer, evenStroke(StrokeSection::Cube, {{-1, y, 0}, {1, y, 0}}, 0.08f,
                                      bars[std::size_t(k)], k % 2 ? 0.7f : 1.f));
    }
    const std::string spaceName = space == BlendSpace::Encoded ? "encoded" : "linear";
    return scene("blend-" + std::string(blendModeName(mode)) + "-" + spaceName, std::move(builder),
                 cameraAt({0, 0, 2.3}));
}

PaintingScene sceneStack()
{
    PaintingScene made = intersectionFromOutside();
    made.name = "scene-stack";
    PaintingBuilder builder;
    builder.painting = std::move(made.painting);
    Layer &layer = builder.addLayer(-1, "Over all");
    layer.properties.blendMode = BlendMode::Screen;
    layer.properties.opacity = 0.8;
    builder.add(layer, evenStroke(StrokeSection::Cube, {{-1, 0.2f, 0}, {1, 0.2f, 0}}, 0.25f, red));
    made.painting = std::move(builder.painting);
    return made;
}

PaintingScene dayAndNight(bool night)
{
    PaintingScene made = sceneStack();
    made.name = night ? "look-night" : "look-day";
    PaintingBuilder builder;
    builder.painting = std::move(made.painting);
    const LookId day = builder.addLook("Day"), dusk = builder.addLook("Night");
    for (const Layer *layer : builder.painting.layers()) {
        LayerProperties properties = layer->properties;
        builder.painting.looks[0].layers.emplace_back(layer->id, properties);
        if (!isSubstrate(builder.painting, layer->id)) {
            properties.blendMode = BlendMode::Multiply;
            properties.colour = purple;
        }
        builder.painting.looks[1].layers.emplace_back(layer->id, properties);
    }
    made.painting = std::move(builder.painting);
    made.moment.look = night ? dusk : day;
    return made;
}

PaintingScene planeAndShadow(double timeSeconds)
{
    PaintingBuilder builder;
    const int ground = addPlate(builder);
    const int plane = builder.addStack("Plane");
    const ElementId body =
        builder.add(builder.substrate(plane),
                    evenStroke(StrokeSection::Round, {{-0.8f, 0, 0.4f}, {-0.4f, 0, 0.4f}}, 0.06f, red));
    const ElementId wing = builder.add(
        builder.substrate(plane),
        evenStroke(StrokeSection::Ellipse, {{-0.6f, -0.3f, 0.4f}, {-0.6f, 0.3f, 0.4f}}, 0.08f, yellow));
    Layer &shadow = builder.addLayer(ground, "Shadow");
    shadow.tolerance = 0.1;
    shadow.properties.blendMode = BlendMode::Multiply;
    const ElementId cast =
        builder.add(shadow, evenStroke(StrokeSection::Ribbon, {{-0.8f, 0, 0.02f}, {-0.4f, 0, 0.02f}}, 0.06f,
                                       purple, 0.7f));
    PlacementKey from, to;
    to.timeSeconds = 2;
    to.placement.translation = {1.1, 0.2, 0};
    to.placement.rotation = Eigen::AngleAxisd(0.4, Vec3::UnitZ());
    builder.addGroup("Flight", {body, wing, cast}, {from, to});
    builder.painting.loopSeconds = 4;
    const int cloud = builder.addStack("Cloud");
    Layer &layer = builder.substrate(cloud);
    builder.add(layer,
                evenStroke(StrokeSection::Round, {{0.5f, 0.4f, 0.2f}, {0.7f, 0.4f, 0.2f}}, 0.12f, paper));
    PlacementKey moved = to;
    moved.placement.translation = {-0.5, -0.3, 0.1};
    moved.placement.rotation.setIdentity();
    layer.motion = {from, moved};
    PaintingScene made = scene("motion-" + std::to_string(int(timeSeconds * 10)), std::move(builder),
                               cameraAt({0.2, -1.2, 2.2}));
    made.moment.timeSeconds = timeSeconds;
    return made;
}

PaintingScene translucentSubstrates()
{
    PaintingBuilder builder;
    addPlate(builder);
    const int glass = builder.addStack("Glass");
    builder.substrate(glass).properties.opacity = 0.5;
    builder.add(builder.substrate(glass),
                evenStroke(StrokeSection::Round, wave(0.2f, 0.3f, 0.2f), 0.15f, blue));
    builder.add(builder.substrate(glass),
                evenStroke(StrokeSection::Round, {{0.3f, -0.6f, 0.5f}, {0.3f, 0.6f, 0.5f}}, 0.1f, red));
    Layer &layer = builder.addLayer(glass, "Band");
    builder.add(layer, evenStroke(StrokeSection::Cube, {{-0.4f, -1, 0.3f}, {-0.4f, 1, 0.3f}}, 0.2f, yellow));
    const int veil = builder.addStack("Veil");
    StrokeShape fading = evenStroke(StrokeSection::Ribbon, wave(-0.3f, 0.2f, 0.1f), 0.2f, dark);
    for (std::size_t i = 0; i < fading.points.size(); ++i)
        fading.points[i].opacity = float(i) / float(fading.points.size() - 1);
    builder.add(builder.substrate(veil), fading);
    return scene("translucent-substrates", std::move(builder), cameraAt({0.2, -0.9, 2.4}));
}

PaintingScene meshes()
{
    PaintingBuilder builder;
    const int stack = builder.addStack("Ball");
    MeshShape ball = ballMesh({0, 0, 0}, 0.6, paper);
    for (std::size_t i = 0; i < ball.vertexColours.size(); ++i)
        ball.vertexColours[i] *= float(0.6 + 0.5 * ball.mesh.vertices[i].z());
    builder.add(builder.substrate(stack), ball);
    Layer &inside = builder.addLayer(stack, "Mesh that cuts");
    builder.add(inside, ballMesh({0.4, 0.3, 0.4}, 0.35, blue));
    Layer &near = builder.addLayer(stack, "Sheet near by");
    near.tolerance = 0.1;
    MeshShape sheet;
    sheet.mesh.vertices = {{-0.3, -0.3, 0.6}, {0.2, -0.3, 0.6}, {-0.3, -0.05, 0.6}};
    sheet.mesh.triangles = {{0, 1, 2}};
    sheet.vertexColours.assign(3, red);
    builder.add(near, sheet);
    return scene("meshes", std::move(builder), cameraAt({0.3, -0.4, 2.4}));
}

std::vector<PaintingScene> allPaintingScenes()
{
    std::vector<PaintingScene> scenes{intersectionFromOutside(),
                                      cameraInsideAStroke(),
                                      selfOverlap(),
                                      strokeOrder(),
                                      opaqueStrokesInClearLayers(),
                                      toleranceReach(),
                                      toleranceOfView(),
                                      allSections(),
                                      mirroredElements(),
                                      hiddenLayers(),
                                      twoHundredStacks(),
                                      sceneStack(),
                                      dayAndNight(false),
                                      dayAndNight(true),
                                      planeAndShadow(0),
                                      planeAndShadow(1.5),
                                      translucentSubstrates(),
                                      meshes()};
    for (int view = 0; view < 7; ++view) {
        scenes.push_back(toleranceOnFlat(view));
        scenes.push_back(toleranceOnBumps(view));
    }
    for (const char *mask :
         {"linear", "spherical", "noise", "texture", "stroke-inside", "stroke-outside", "two"})
        scenes.push_back(masked(mask));
    for (int mode = 0; mode < blendModeCount; ++mode)
        for (const BlendSpace space : {BlendSpace::Encoded, BlendSpace::Linear})
            scenes.push_back(blended(BlendMode(mode), space));
    return scenes;
}

} // namespace ductus
