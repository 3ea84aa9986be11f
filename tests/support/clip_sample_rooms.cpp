// The clips of the room with boxes: a box that passes, a walk into it.
#include "support/clip_doodles.h"
#include "support/clip_samples.h"

namespace ductus {

namespace {

constexpr int frames = 72;

// Three frames: it looks ahead, laughs, blinks.
void drawFace(Canvas &canvas)
{
    constexpr double pi = std::numbers::pi;
    canvas.doodle.frames.assign(3, DoodleFrame{{}, 4});
    canvas.doodle.repeat = DoodleRepeat::PingPong;
    for (int i = 0; i < 3; ++i) {
        const bool isBlinking = i == 2;
        for (double side : {-1.0, 1.0}) {
            const Vec2 eye(0.13 * side, -0.1);
            if (isBlinking) {
                draw(canvas, i, penLine(arcPoints(eye, 0.055, 0.03, 0.1 * pi, 0.9 * pi), 0.025, inkColour));
                continue;
            }
            draw(canvas, i, FilledShape{arcPoints(eye, 0.07, 0.085, 0.0, 2.0 * pi), {255, 255, 255, 255}});
            draw(canvas, i, penLine(arcPoints(eye, 0.07, 0.085, 0.0, 2.0 * pi), 0.016, inkColour));
            draw(canvas, i,
                 FilledShape{arcPoints(eye + Vec2(0.02, 0.01), 0.03, 0.035, 0.0, 2.0 * pi), inkColour});
        }
        if (i == 1)
            draw(canvas, i, FilledShape{arcPoints({0.0, 0.08}, 0.15, 0.14, 0.0, pi), redInk});
        draw(canvas, i,
             penLine(arcPoints({0.0, 0.07}, 0.16, i == 1 ? 0.15 : 0.1, 0.05 * pi, 0.95 * pi), 0.028,
                     inkColour));
    }
}

} // namespace

SampleClip passingBox()
{
    SampleClip sample{"passing-box",
                      "Passing box",
                      "A face follows the box behind the post; words and arrow stay in the room.",
                      passingScene(sampleWidth, sampleHeight, frames),
                      {},
                      24};
    // The front of the box when it starts and when it stops (passingScene).
    const Vec3 middle(0.0, 0.0, -0.31);
    const ClipBody &box = sample.scene.bodies.back();
    Canvas face = placedCanvas(sample.scene, "Face", 0, box.worldFromBody(0) * middle,
                               Eigen::Quaterniond(box.worldFromBody(0).linear()));
    face.motion = CanvasMotion::Dynamic;
    face.turning = CanvasTurning::Still;
    // From the second keyframe on straight ahead: behind the post there is nothing to follow.
    for (const int frame : {frames / 4, frames - 1}) {
        const Eigen::Isometry3d pose = box.worldFromBody(frame);
        const ShotCamera camera = sample.scene.camera(frame);
        const Vec3 place = pose * middle;
        face.keyframes.positions.push_back({frame, *camera.projected(place), camera.depthOf(place), true});
        face.keyframes.turns.push_back({frame, Eigen::Quaterniond(pose.linear()), true});
    }
    face.size = Vec2(0.7, 0.8);
    drawFace(face);
    addCanvas(sample.doodles, face);

    Canvas words = placedCanvas(sample.scene, "Words", 0, {2.15, -0.75, 6.9});
    words.size = Vec2(2.6, 1.0);
    draw(words, 0,
         TextMark{"v = s / t", {0.0, 0.0}, 0.62, 0.0, true, {250, 250, 250, 255}, {30, 45, 80, 255}});
    addCanvas(sample.doodles, words);

    // Upright above where the box slides.
    Canvas path = placedCanvas(sample.scene, "Path", 36, {0.0, 0.2, 3.1});
    path.size = Vec2(3.0, 0.5);
    draw(path, 0, ArrowMark{{{-1.2, 0.0}, {-0.4, 0.03}, {0.4, 0.0}, {1.2, -0.04}}, 0.06, redInk});
    addCanvas(sample.doodles, path);
    return sample;
}

SampleClip walkThrough()
{
    SampleClip sample{"walk-through",
                      "Walk through the room",
                      "Labels and stickers keep their place in the room while the camera walks in.",
                      forwardScene(sampleWidth, sampleHeight, frames),
                      {},
                      40};
    Canvas heavy = placedCanvas(sample.scene, "Heavy", 0, {-1.42, -0.45, 3.85});
    heavy.size = Vec2(1.2, 0.9);
    draw(heavy, 0, TextMark{"heavy", {0.0, -0.15}, 0.34});
    draw(heavy, 0, ArrowMark{{{0.0, 0.05}, {-0.02, 0.2}, {0.02, 0.42}}, 0.05, redInk});
    addCanvas(sample.doodles, heavy);

    Canvas star = placedCanvas(sample.scene, "Star", 0, {1.32, 0.86, 2.86},
                               Eigen::Quaterniond(Eigen::AngleAxisd(-0.5, Vec3::UnitY())));
    star.doodle.frames.assign(2, DoodleFrame{{}, 6});
    draw(star, 0, StickerMark{"star", {0.0, 0.0}, 0.5, -0.12, yellowInk});
    draw(star, 1, StickerMark{"star", {0.0, 0.0}, 0.5, 0.12, yellowInk});
    addCanvas(sample.doodles, star);

    Canvas bubble = placedCanvas(sample.scene, "Who is there?", 0, {0.95, -0.62, 5.2});
    bubble.size = Vec2(1.3, 1.0);
    bubble.shownFrom = 12;
    draw(bubble, 0, StickerMark{"bubble", {0.0, 0.0}, 1.2, 0.0, inkColour});
    draw(bubble, 0, TextMark{"Hello!", {0.0, -0.07}, 0.34, 0.0, true, inkColour, {255, 255, 255, 0}});
    addCanvas(sample.doodles, bubble);
    return sample;
}

} // namespace ductus
