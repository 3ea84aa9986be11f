// A ghost in a store room: a loop of drawings that goes its own way, behind what is nearer.
#include "support/clip_doodles.h"
#include "support/clip_samples.h"
#include "support/clip_stage.h"

#include <cmath>

namespace ductus {

namespace {

constexpr int frames = 60, drawings = 6;
constexpr double floorY = 1.2;

ClipScene stage()
{
    ClipScene scene;
    scene.name = "ghost";
    scene.width = sampleWidth;
    scene.height = sampleHeight;
    scene.frameCount = frames;
    ClipBody room;
    const ClipTexture wall = calmTexture(1, 0x4f5a78, 0.5, 0.22);
    room.panels = {
        groundPanel(floorY, 3.4, -1.5, 6.5, calmTexture(2, 0x5f4a44, 0.4, 0.28)),
        uprightPanel({0, -0.3, 6.5}, 3.4, 1.6, wall),
        {{-3.4, -0.3, 2.5}, {0, 0, 4.0}, {0, 1.6, 0}, false, calmTexture(3, 0x465272, 0.5, 0.22)},
        {{3.4, -0.3, 2.5}, {0, 0, 4.0}, {0, 1.6, 0}, false, calmTexture(4, 0x465272, 0.5, 0.22)},
        discPanel({1.75, -0.85, 6.45}, 0.5, calmTexture(5, 0xe8e2bf, 0.3, 0.12))}; // the moon in a window
    scene.bodies.push_back(room);
    scene.bodies.push_back(
        boxBody({-1.55, 0.55, 4.3}, {0.5, 0.65, 0.45}, 0.3, calmTexture(10, 0x9a6b45, 0.25, 0.35)));
    scene.bodies.push_back(
        boxBody({-1.6, -0.4, 4.35}, {0.36, 0.3, 0.36}, -0.15, calmTexture(20, 0xb08350, 0.22, 0.35)));
    scene.bodies.push_back(
        boxBody({1.25, 0.75, 3.5}, {0.45, 0.45, 0.45}, -0.4, calmTexture(30, 0x8a5d3c, 0.25, 0.35)));
    scene.bodies.push_back(
        boxBody({0.25, -0.05, 4.9}, {0.17, 1.25, 0.17}, 0.4, calmTexture(40, 0x6d707a, 0.2, 0.3)));
    scene.camera = cameraPath(scene, {-0.25, 0.0, -0.7}, {0.2, -0.02, 0.3}, 0.02, -0.02, 0.06);
    return scene;
}

void drawGhost(Canvas &canvas, int drawing)
{
    const double pi = std::numbers::pi, phase = 2 * pi * drawing / drawings;
    std::vector<Vec2> outline = arcPoints({0, -0.12}, 0.3, 0.34, pi, 2 * pi);
    const int hems = 18; // the hem waves from drawing to drawing
    for (int i = 0; i <= hems; ++i) {
        const double t = double(i) / hems;
        outline.emplace_back(0.3 - 0.6 * t + 0.05 * std::sin(phase) * 1.0,
                             0.36 + 0.055 * std::sin(3.0 * 2 * pi * t + phase));
    }
    draw(canvas, drawing, FilledShape{outline, {245, 248, 255, 225}});
    std::vector<Vec2> rim = outline;
    rim.push_back(outline.front());
    InkStroke edge = penLine(rim, 0.022, {70, 80, 120, 255});
    edge.line.pressure.assign(edge.line.pressure.size(), 0.8);
    draw(canvas, drawing, edge);
    const bool isBlinking = drawing == drawings - 1;
    for (const double side : {-1.0, 1.0}) {
        if (isBlinking)
            draw(canvas, drawing,
                 penLine(arcPoints({0.1 * side, -0.12}, 0.05, 0.02, 0, pi), 0.022, inkColour));
        else
            draw(canvas, drawing, FilledShape{arcPoints({0.1 * side, -0.12}, 0.042, 0.065), inkColour});
        draw(canvas, drawing,
             FilledShape{arcPoints({0.19 * side, -0.01}, 0.045, 0.028), {255, 170, 190, 200}});
        draw(canvas, drawing, // arms
             penLine({{0.28 * side, 0.02},
                      {0.38 * side, 0.02 - 0.07 * std::sin(phase + side)},
                      {0.46 * side, -0.08 * std::sin(phase + side)}},
                     0.035, {70, 80, 120, 255}));
    }
    draw(canvas, drawing,
         FilledShape{arcPoints({0, 0.03}, 0.045, 0.05 + 0.015 * std::sin(phase)), inkColour});
}

} // namespace

SampleClip ghostInTheStore()
{
    SampleClip sample{"ghost",
                      "A ghost in the store",
                      "Six drawings in a loop; keyframes carry them around the post and behind the boxes.",
                      stage(),
                      {},
                      33};
    const std::pair<int, Vec3> way[] = {{0, {-2.5, -0.15, 5.5}}, {12, {-1.55, -0.1, 5.6}},
                                        {24, {-0.5, -0.3, 5.4}}, {36, {0.62, -0.05, 5.2}},
                                        {48, {1.45, 0.1, 4.6}},  {59, {2.3, -0.35, 4.2}}};
    Canvas ghost = placedCanvas(sample.scene, "Ghost", 0, way[0].second);
    for (const auto &[frame, place] : way)
        if (frame > 0)
            keyCanvas(ghost, sample.scene, frame, place);
    ghost.size = Vec2(1.2, 1.2);
    ghost.keyframes.scales = {{0, 1.45}};
    ghost.doodle.frames.assign(drawings, DoodleFrame{{}, 3});
    for (int drawing = 0; drawing < drawings; ++drawing)
        drawGhost(ghost, drawing);
    addCanvas(sample.doodles, ghost);

    Canvas boo = placedCanvas(sample.scene, "Boo", 36, {0.1, -0.72, 4.4});
    boo.size = Vec2(1.0, 0.7);
    boo.shownFrom = 26;
    boo.shownUntil = 50;
    boo.doodle.frames.assign(2, DoodleFrame{{}, 4});
    for (int drawing = 0; drawing < 2; ++drawing)
        draw(boo, drawing,
             TextMark{"Boo!",
                      {0.0, 0.0},
                      0.42,
                      drawing ? 0.07 : -0.07,
                      true,
                      {255, 240, 160, 255},
                      {60, 50, 100, 255}});
    addCanvas(sample.doodles, boo);

    Canvas stars = placedCanvas(sample.scene, "Around the moon", 0, {1.75, -0.85, 6.35});
    stars.size = Vec2(2.0, 1.4);
    stars.doodle.frames.assign(2, DoodleFrame{{}, 7});
    for (int drawing = 0; drawing < 2; ++drawing)
        for (int k = 0; k < 5; ++k) {
            const double angle = 2.2 + 1.25 * k;
            draw(stars, drawing,
                 StickerMark{"star", Vec2(0.85 * std::cos(angle), 0.68 * std::sin(angle)),
                             (k + drawing) % 2 ? 0.18 : 0.25, 0.3 * k, yellowInk});
        }
    addCanvas(sample.doodles, stars);
    return sample;
}

} // namespace ductus
