#include "benchmarks/layers/stroke_scene.h"

#include "base/random.h"

#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

namespace ductus {

namespace {

std::shared_ptr<const ElementShape> stroke(Random &random, double size, double spacing)
{
    StrokeShape shape;
    shape.section = StrokeSection::Round;
    const double angle = random.uniform(0, 2 * std::numbers::pi), bend = random.uniform(-0.15, 0.15);
    const double step = spacing / 2, width = spacing * random.uniform(0.4, 0.7);
    Vec3 at(random.uniform(-0.5, 0.5) * size, random.uniform(-0.5, 0.5) * size,
            random.uniform(-0.5, 0.5) * width);
    const Eigen::Vector3f colour(float(random.uniform()), float(random.uniform()), float(random.uniform()));
    for (int i = 0; i < 12; ++i) {
        const double taper = std::sin(std::numbers::pi * (i + 0.5) / 12);
        shape.points.push_back(
            {at.cast<float>(), Eigen::Vector3f::UnitZ(), float(width * std::sqrt(taper)), colour, 1});
        at += step * Vec3(std::cos(angle + bend * i), std::sin(angle + bend * i), 0);
    }
    return std::make_shared<const ElementShape>(std::move(shape));
}

} // namespace

StrokeScene strokeScene(int strokes, int layers, std::uint64_t seed, double size)
{
    StrokeScene scene;
    Painting &painting = scene.painting;
    const auto layer = [&](const std::string &name) {
        Layer made;
        made.id.value = painting.nextId++;
        made.name = name;
        return made;
    };
    Stack stack;
    stack.id.value = painting.nextId++;
    stack.name = "ground";
    stack.substrate = layer("ground");
    // As painters use them: plain colour, shade, light, mood.
    constexpr std::array<std::pair<BlendMode, double>, 4> uses{{{BlendMode::Normal, 1},
                                                                {BlendMode::Multiply, 0.7},
                                                                {BlendMode::Screen, 0.5},
                                                                {BlendMode::Overlay, 0.6}}};
    for (int i = 0; i < layers; ++i) {
        Layer &made = stack.appearance.emplace_back(layer("layer " + std::to_string(i)));
        std::tie(made.properties.blendMode, made.properties.opacity) = uses[std::size_t(i) % uses.size()];
    }
    Random random(seed);
    const double spacing = size / std::sqrt(double(strokes)); // so that they cover the ground about twice
    for (int i = 0; i < strokes; ++i) {
        // Neighbours in a layer are neighbours in no other order than that of painting.
        Layer &to =
            layers == 0 || i % 2 == 0
                ? *stack.substrate
                : stack.appearance[std::size_t(i / 2) * std::size_t(layers) / std::size_t((strokes + 1) / 2)];
        to.drawings[0].elements.push_back({ElementId{painting.nextId++}, {}, stroke(random, size, spacing)});
    }
    painting.stacks.push_back(std::move(stack));
    scene.camera = FrameCamera::lookingAt(Vec3(0.3 * size, -0.5 * size, size), Vec3::Zero(), 60, 1);
    return scene;
}

} // namespace ductus
