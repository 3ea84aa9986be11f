// A lesson: the pendulum is fastest at the bottom. The arrow is drawn anew as the speed changes.
#include "support/clip_doodles.h"
#include "support/clip_samples.h"
#include "support/clip_stage.h"

#include <cmath>

namespace ductus {

namespace {

constexpr int frames = 72, period = 36, hold = 3;
constexpr double length = 1.35, swing = 0.62;
const Vec3 pivot(0.35, -0.78, 3.6);

double angleAt(double frame)
{
    return swing * std::cos(2.0 * std::numbers::pi * frame / period);
}

// Of the swing, -1..1; to the right is positive: a growing angle swings to the left.
double speedAt(double frame)
{
    return std::sin(2.0 * std::numbers::pi * frame / period);
}

Vec3 bobAt(double frame, double along = length)
{
    const double angle = angleAt(frame);
    return pivot + along * Vec3(-std::sin(angle), std::cos(angle), 0.0);
}

ClipScene stage()
{
    ClipScene scene;
    scene.name = "pendulum";
    scene.width = sampleWidth;
    scene.height = sampleHeight;
    scene.frameCount = frames;
    ClipBody room;
    room.panels = {
        uprightPanel({0, -0.6, 4.6}, 4.5, 2.2, calmTexture(1, 0xa9b7b4, 0.6, 0.22)),
        groundPanel(0.95, 4.5, 0.5, 4.6, calmTexture(2, 0x9a7a58, 0.4, 0.3)),
        uprightPanel({-1.4, -0.45, 4.5}, 0.9, 0.62, calmTexture(3, 0x2f4a40, 0.5, 0.16)), // a board
        uprightPanel({-1.4, 0.21, 4.48}, 0.95, 0.04, calmTexture(4, 0x8a6a48, 0.2, 0.3))};
    scene.bodies.push_back(room);
    const ClipTexture wood = calmTexture(10, 0x7d5c3f, 0.15, 0.4);
    scene.bodies.push_back(boxBody({1.62, 0.05, 3.75}, {0.05, 0.9, 0.05}, 0.2, wood)); // stand
    scene.bodies.push_back(boxBody({0.95, -0.81, 3.75}, {0.72, 0.045, 0.045}, 0.0, wood));
    scene.bodies.push_back(boxBody({1.62, 0.9, 3.75}, {0.34, 0.05, 0.26}, 0.2, wood));
    ClipBody swinging;
    swinging.panels = {
        uprightPanel({0, 0.5 * length, 0}, 0.012, 0.5 * length, calmTexture(20, 0x3a3f4a, 0.05, 0.3)),
        discPanel({0, length, -0.02}, 0.2, calmTexture(21, 0xc8452f, 0.11, 0.55))};
    swinging.worldFromBody = [](int frame) {
        return Eigen::Isometry3d(Eigen::Translation3d(pivot) *
                                 Eigen::AngleAxisd(angleAt(frame), Vec3::UnitZ()));
    };
    scene.bodies.push_back(swinging);
    scene.camera = cameraPath(scene, {0, 0, 0}, {0, 0, 0}, 0.0, 0.0, 0.03);
    return scene;
}

} // namespace

SampleClip pendulum()
{
    SampleClip sample{"pendulum",
                      "Pendulum",
                      "A still camera; the arrow rides on the bob and is drawn anew twelve times a swing.",
                      stage(),
                      {},
                      7};
    Canvas way = placedCanvas(sample.scene, "Way of the bob", 0, pivot + Vec3(0, length, 0.05));
    way.size = Vec2(2.0, 0.6);
    std::vector<Vec2> bow;
    for (int i = 0; i <= 24; ++i) {
        const double angle = swing * (1.0 - i / 12.0);
        bow.emplace_back(-length * std::sin(angle), length * (std::cos(angle) - 1.0));
    }
    for (std::size_t i = 0; i + 2 < bow.size(); i += 3) // dashes
        draw(way, 0, penLine({bow[i], bow[i + 1], bow[i + 2]}, 0.03, {255, 255, 255, 210}));
    addCanvas(sample.doodles, way);

    const Vec3 before(0, 0, -0.1);
    Canvas speed = placedCanvas(sample.scene, "Speed", 0, bobAt(0) + before);
    speed.size = Vec2(1.4, 0.5);
    std::vector<int> keys;
    for (int frame = hold; frame < frames; frame += hold)
        keys.push_back(frame);
    keys.push_back(frames - 1);
    for (const int frame : keys)
        keyCanvas(speed, sample.scene, frame, bobAt(frame) + before,
                  Eigen::Quaterniond(Eigen::AngleAxisd(angleAt(frame), Vec3::UnitZ())));
    speed.keyframes.turns[0].worldFromCanvas = Eigen::AngleAxisd(angleAt(0), Vec3::UnitZ());
    speed.doodle.frames.assign(period / hold, DoodleFrame{{}, hold});
    for (int i = 0; i < period / hold; ++i) {
        const double fast = speedAt((i + 0.5) * hold);
        if (std::abs(fast) < 0.3)
            draw(speed, i, FilledShape{arcPoints({0, 0}, 0.05, 0.05), yellowInk});
        else
            draw(speed, i, ArrowMark{{{0.0, 0.0}, {0.35 * fast, 0.0}, {0.7 * fast, 0.0}}, 0.05, yellowInk});
    }
    addCanvas(sample.doodles, speed);

    Canvas board = placedCanvas(sample.scene, "On the board", 0, {-1.4, -0.45, 4.45});
    board.size = Vec2(1.8, 1.2);
    const Rgba chalk = {240, 240, 225, 255}, none = {0, 0, 0, 0};
    draw(board, 0, TextMark{"T = 2\u03c0", {-0.4, -0.18}, 0.3, 0.0, false, chalk, none});
    draw(board, 0, TextMark{"l", {0.33, -0.32}, 0.27, 0.0, false, chalk, none});
    draw(board, 0, TextMark{"g", {0.33, 0.0}, 0.27, 0.0, false, chalk, none});
    draw(board, 0, penLine({{0.2, -0.15}, {0.33, -0.155}, {0.46, -0.15}}, 0.022, chalk));
    draw(board, 0,
         penLine({{-0.02, -0.12}, {0.04, -0.16}, {0.1, 0.1}, {0.16, -0.46}, {0.34, -0.47}, {0.55, -0.46}},
                 0.026, chalk));
    draw(board, 0,
         TextMark{"fast at the bottom", {0.0, 0.4}, 0.17, -0.03, false, {255, 225, 130, 255}, none});
    addCanvas(sample.doodles, board);
    return sample;
}

} // namespace ductus
