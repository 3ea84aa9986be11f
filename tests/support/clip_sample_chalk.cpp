// Chalk: canvases that lie on the ground and on a wall.
#include "support/clip_doodles.h"
#include "support/clip_samples.h"
#include "support/clip_stage.h"

#include <cmath>
#include <string>

namespace ductus {

namespace {

constexpr int frames = 60;
constexpr double groundY = 1.3, wallZ = 6.4;
constexpr Rgba chalk = {248, 246, 236, 255}, pink = {255, 150, 170, 255}, blue = {120, 190, 255, 255},
               none = {0, 0, 0, 0};

ClipScene stage()
{
    ClipScene scene;
    scene.name = "chalk";
    scene.width = sampleWidth;
    scene.height = sampleHeight;
    scene.frameCount = frames;
    ClipBody yard;
    yard.panels = {groundPanel(groundY, 6, 0.2, wallZ, calmTexture(1, 0x6f747a, 0.5, 0.24)),
                   uprightPanel({0, -0.5, wallZ}, 6, 1.8, calmTexture(2, 0xa8604a, 0.42, 0.3)),
                   uprightPanel({0, 1.2, wallZ - 0.05}, 6, 0.12, calmTexture(3, 0x8b8880, 0.5, 0.25))};
    scene.bodies.push_back(yard);
    scene.bodies.push_back(
        boxBody({2.15, 0.8, 4.9}, {0.5, 0.5, 0.5}, 0.35, calmTexture(10, 0xb98d56, 0.3, 0.4)));
    scene.bodies.push_back(
        boxBody({1.95, -0.02, 4.95}, {0.34, 0.32, 0.34}, -0.2, calmTexture(20, 0xc9a064, 0.25, 0.4)));
    scene.bodies.push_back(
        boxBody({-2.5, 0.75, 5.4}, {0.42, 0.55, 0.42}, 0.1, calmTexture(30, 0x3f6f5c, 0.3, 0.35)));
    scene.camera = cameraPath(scene, {-0.75, -0.3, -0.1}, {0.65, -0.38, 0.25}, 0.12, -0.08, 0.2);
    return scene;
}

void square(Canvas &canvas, const Vec2 &middle, const std::string &number, const Rgba &colour)
{
    const double h = 0.27, w = 0.035;
    const Vec2 a = middle + Vec2(-h, -h), b = middle + Vec2(h, -h), c = middle + Vec2(h, h),
               d = middle + Vec2(-h, h);
    for (const auto &[from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, d), std::pair(d, a)})
        draw(canvas, 0,
             penLine({from - 0.04 * (to - from), 0.5 * (from + to) + Vec2(0.008, -0.008),
                      to + 0.04 * (to - from)},
                     w, colour));
    draw(canvas, 0, TextMark{number, middle, 0.4, 0.0, true, colour, none});
}

void drawCat(Canvas &canvas)
{
    const double pi = std::numbers::pi;
    draw(canvas, 0,
         penLine(arcPoints({0, 0.05}, 0.42, 0.36, -0.5 * pi + 0.55, 1.5 * pi - 0.55), 0.045, chalk));
    draw(canvas, 0, penLine({{-0.23, -0.26}, {0.0, -0.3}, {0.23, -0.26}}, 0.04, chalk));
    for (const double side : {-1.0, 1.0}) {
        draw(canvas, 0,
             penLine({{0.38 * side, -0.12}, {0.38 * side, -0.52}, {0.2 * side, -0.27}}, 0.045, chalk));
        draw(canvas, 0, FilledShape{arcPoints({0.16 * side, 0.0}, 0.05, 0.08), blue});
        for (const double y : {0.13, 0.2})
            draw(canvas, 0,
                 penLine({{0.16 * side, y}, {0.4 * side, y - 0.03}, {0.62 * side, y - 0.05}}, 0.022, chalk));
    }
    draw(canvas, 0, FilledShape{{{-0.05, 0.12}, {0.05, 0.12}, {0.0, 0.18}}, pink});
    draw(canvas, 0, penLine(arcPoints({-0.07, 0.2}, 0.07, 0.07, 0.1 * pi, pi), 0.025, chalk));
    draw(canvas, 0, penLine(arcPoints({0.07, 0.2}, 0.07, 0.07, 0.0, 0.9 * pi), 0.025, chalk));
}

} // namespace

SampleClip chalkYard()
{
    SampleClip sample{
        "chalk",
        "Chalk in the yard",
        "Canvases lie on the ground and on the wall and keep their perspective as the camera goes by.",
        stage(),
        {},
        30};
    const Eigen::Quaterniond flat(Eigen::AngleAxisd(-0.5 * std::numbers::pi, Vec3::UnitX()));
    Canvas hopscotch = placedCanvas(sample.scene, "Hopscotch", 0, {-0.1, groundY - 0.01, 4.55}, flat);
    hopscotch.size = Vec2(1.4, 3.2);
    hopscotch.occlusion.bias = 0.06; // it lies on what must not hide it
    const double step = 0.56;
    square(hopscotch, {0, 2 * step}, "1", chalk);
    square(hopscotch, {0, step}, "2", pink);
    square(hopscotch, {-0.5 * step, 0}, "3", chalk);
    square(hopscotch, {0.5 * step, 0}, "4", chalk);
    square(hopscotch, {0, -step}, "5", blue);
    square(hopscotch, {-0.5 * step, -2 * step}, "6", chalk);
    square(hopscotch, {0.5 * step, -2 * step}, "7", chalk);
    addCanvas(sample.doodles, hopscotch);

    Canvas cat = placedCanvas(sample.scene, "Cat", 0, {-0.95, 0.15, wallZ - 0.02});
    cat.size = Vec2(1.5, 1.3);
    cat.occlusion.bias = 0.06;
    drawCat(cat);
    addCanvas(sample.doodles, cat);

    Canvas sun = placedCanvas(sample.scene, "Sun", 0, {0.95, -0.28, wallZ - 0.02});
    sun.size = Vec2(1.4, 1.4);
    sun.occlusion.bias = 0.06;
    sun.doodle.frames.assign(2, DoodleFrame{{}, 8}); // its rays twinkle
    for (int drawing = 0; drawing < 2; ++drawing) {
        draw(sun, drawing, FilledShape{arcPoints({0, 0}, 0.25, 0.25), {255, 214, 90, 255}});
        for (int k = 0; k < 10; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5 * drawing) / 10;
            const Vec2 way(std::cos(angle), std::sin(angle));
            draw(sun, drawing,
                 penLine({0.33 * way, 0.42 * way, (k % 2 == 0 ? 0.55 : 0.48) * way}, 0.045, yellowInk));
        }
    }
    addCanvas(sample.doodles, sun);

    // On the left side of the crate, which is turned.
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.35, Vec3::UnitY()));
    Canvas arrow = placedCanvas(sample.scene, "This side up", 0,
                                Vec3(2.15, 0.8, 4.9) + turned * Vec3(0, 0, -0.52), turned);
    arrow.size = Vec2(0.9, 0.9);
    arrow.occlusion.bias = 0.06;
    draw(arrow, 0, ArrowMark{{{0.0, 0.32}, {0.0, 0.0}, {0.0, -0.32}}, 0.09, inkColour});
    addCanvas(sample.doodles, arrow);
    return sample;
}

} // namespace ductus
