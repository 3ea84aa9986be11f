// A camera that turns on its tripod over hills cut out of paper.
#include "support/clip_doodles.h"
#include "support/clip_samples.h"
#include "support/clip_stage.h"

#include <cmath>

namespace ductus {

namespace {

constexpr int frames = 60;

// A row of hills: discs behind a sheet, \a top is where the sheet begins.
ClipBody hills(double z, double top, double radius, double step, unsigned rgb, std::uint32_t seed)
{
    ClipBody body;
    const ClipTexture texture = calmTexture(seed, rgb, 0.16 * radius, 0.26);
    body.panels.push_back(uprightPanel({0, top + 4, z}, 14, 4, texture));
    for (double x = -12; x <= 12; x += step) {
        const double high = radius * (0.8 + 0.25 * std::sin(1.7 * x + seed));
        body.panels.push_back(discPanel({x, top + 0.3 * radius, z + 0.001}, high, texture));
    }
    return body;
}

ClipScene stage()
{
    ClipScene scene;
    scene.name = "hills";
    scene.width = sampleWidth;
    scene.height = sampleHeight;
    scene.frameCount = frames;
    ClipBody sky;
    sky.panels = {uprightPanel({0, -4, 22}, 30, 12, calmTexture(1, 0xa9d0e2, 4.0, 0.14))};
    scene.bodies = {sky, hills(17, 1.0, 2.6, 3.1, 0x8fb0b4, 11), hills(12.5, 1.15, 1.7, 2.3, 0x7fa58a, 22),
                    hills(9, 1.15, 0.95, 1.6, 0x6f9a5c, 33)};
    scene.bodies.push_back(
        boxBody({1.15, 0.35, 8.3}, {0.5, 0.36, 0.4}, 0.5, calmTexture(40, 0xd9cdb4, 0.3, 0.3))); // a house
    ClipBody roof;
    roof.panels = {{{1.15, -0.17, 8.0},
                    {0.55, 0.06, -0.3},
                    {0.12, 0.22, 0.2},
                    false,
                    calmTexture(50, 0xb0503c, 0.15, 0.35)},
                   {{1.15, -0.17, 8.35},
                    {0.55, 0.06, -0.3},
                    {-0.12, 0.22, -0.2},
                    false,
                    calmTexture(51, 0x98432f, 0.15, 0.35)}};
    scene.bodies.push_back(roof);
    scene.camera = cameraPath(scene, {0, 0, 0}, {0, 0, 0}, -0.24, 0.2, -0.04);
    return scene;
}

// Wings up, level, down, level.
void drawBird(Canvas &canvas, const Rgba &colour)
{
    canvas.doodle.frames.assign(4, DoodleFrame{{}, 3});
    const double lifts[] = {-0.28, -0.06, 0.2, -0.02};
    for (int drawing = 0; drawing < 4; ++drawing) {
        draw(canvas, drawing, FilledShape{arcPoints({0, 0.02}, 0.17, 0.07), colour});
        draw(canvas, drawing, FilledShape{{{-0.15, 0.0}, {-0.33, -0.06}, {-0.31, 0.05}}, colour});
        draw(canvas, drawing, FilledShape{arcPoints({0.17, -0.03}, 0.075, 0.065), colour});
        draw(canvas, drawing, FilledShape{{{0.23, -0.06}, {0.33, -0.02}, {0.23, 0.01}}, {245, 170, 60, 255}});
        draw(canvas, drawing, FilledShape{arcPoints({0.19, -0.05}, 0.014, 0.016), inkColour});
        const double lift = lifts[drawing];
        draw(canvas, drawing,
             FilledShape{{{-0.08, 0.0}, {0.08, 0.0}, {0.0, lift}, {-0.16, 1.25 * lift}}, whiteInk});
        draw(canvas, drawing,
             penLine({{-0.16, 1.25 * lift}, {-0.12, 0.6 * lift}, {-0.08, 0.0}}, 0.02, colour));
        draw(canvas, drawing, penLine({{-0.16, 1.25 * lift}, {0.0, lift}, {0.08, 0.0}}, 0.024, colour));
    }
}

} // namespace

SampleClip panOverHills()
{
    SampleClip sample{"hills",
                      "Over the hills",
                      "The camera only turns: birds fly by keyframes, one of them behind the house.",
                      stage(),
                      {},
                      30};
    Canvas sun = placedCanvas(sample.scene, "Sun", 0, {-5.4, -3.6, 20});
    sun.size = Vec2(4, 4);
    sun.doodle.frames.assign(3, DoodleFrame{{}, 5});
    for (int drawing = 0; drawing < 3; ++drawing) {
        for (int k = 0; k < 12; ++k) {
            const double angle = 2 * std::numbers::pi * (k + drawing / 3.0) / 12;
            const Vec2 way(std::cos(angle), std::sin(angle));
            draw(sun, drawing, penLine({1.1 * way, 1.3 * way, 1.6 * way}, 0.15, yellowInk));
        }
        draw(sun, drawing, FilledShape{arcPoints({0, 0}, 0.9, 0.9), yellowInk});
        for (const double side : {-1.0, 1.0})
            draw(sun, drawing,
                 FilledShape{arcPoints({0.3 * side, -0.15}, 0.08, drawing == 2 ? 0.02 : 0.12), inkColour});
        draw(sun, drawing,
             penLine(arcPoints({0, 0.12}, 0.38, 0.3, 0.1 * std::numbers::pi, 0.9 * std::numbers::pi), 0.09,
                     inkColour));
    }
    addCanvas(sample.doodles, sun);

    Canvas near = placedCanvas(sample.scene, "Red bird", 0, {-2.1, -0.55, 6.5});
    near.size = Vec2(1, 1);
    keyCanvas(near, sample.scene, 20, {-0.75, -1.2, 6.3});
    keyCanvas(near, sample.scene, 40, {0.6, -1.3, 6.2});
    keyCanvas(near, sample.scene, 59, {1.9, -1.15, 6.2});
    near.keyframes.scales = {{0, 1.5}};
    drawBird(near, {205, 70, 60, 255});
    addCanvas(sample.doodles, near);

    Canvas far = placedCanvas(sample.scene, "Blue bird behind the house", 0, {3.4, -1.6, 10.5});
    far.size = Vec2(1, 1);
    keyCanvas(far, sample.scene, 24, {1.5, -0.2, 10.5},
              Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitY())));
    keyCanvas(far, sample.scene, 59, {-1.6, -0.9, 10.5},
              Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitY())));
    far.keyframes.turns[0].worldFromCanvas =
        Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitY()); // it flies to the left
    far.keyframes.scales = {{0, 1.6}};
    drawBird(far, {60, 95, 190, 255});
    addCanvas(sample.doodles, far);

    Canvas smoke = placedCanvas(sample.scene, "Smoke", 30, {1.25, -0.95, 8.0});
    smoke.size = Vec2(1, 1.2);
    smoke.doodle.frames.assign(4, DoodleFrame{{}, 4});
    for (int drawing = 0; drawing < 4; ++drawing)
        for (int k = 0; k < 3; ++k) {
            const double up = 0.42 - 0.4 * (k + drawing / 4.0);
            const double fade = 230 - 55 * (k + drawing / 4.0);
            draw(smoke, drawing,
                 penLine(arcPoints({0.1 * std::sin(4 * up), up}, 0.1 + 0.05 * k, 0.08 + 0.03 * k, 0.3, 5.6),
                         0.05, {255, 255, 255, std::uint8_t(fade)}));
        }
    addCanvas(sample.doodles, smoke);

    Canvas label = placedCanvas(sample.scene, "Home", 30, {0.05, -0.75, 8.2});
    label.size = Vec2(1.6, 0.8);
    draw(label, 0, TextMark{"home", {-0.25, -0.05}, 0.42, -0.05});
    draw(label, 0, ArrowMark{{{0.2, 0.12}, {0.42, 0.28}, {0.62, 0.55}}, 0.05, redInk});
    addCanvas(sample.doodles, label);
    return sample;
}

} // namespace ductus
