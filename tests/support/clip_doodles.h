// Canvases and marks of the bundled clips: laid where a thing of the scene is, drawn as a hand would.
#pragma once

#include "doodling/canvas/canvas.h"
#include "support/clip_scenes.h"

#include <numbers>

namespace ductus {

inline constexpr int sampleWidth = 640, sampleHeight = 360;
inline constexpr Rgba inkColour = {35, 30, 45, 255}, redInk = {225, 60, 50, 255},
                      yellowInk = {255, 205, 60, 255}, whiteInk = {250, 250, 250, 255};

/// A canvas whose middle is at \a place of the world in \a frame, as if it had been dragged there.
Canvas placedCanvas(const ClipScene &scene, const std::string &name, int frame, const Vec3 &place,
                    const Eigen::Quaterniond &turn = Eigen::Quaterniond::Identity());

/// It is at \a place in \a frame, too, and goes there straight from the keyframe before.
void keyCanvas(Canvas &canvas, const ClipScene &scene, int frame, const Vec3 &place,
               const Eigen::Quaterniond &turn = Eigen::Quaterniond::Identity());

/// A line that swells in its middle, as a pen does.
InkStroke penLine(const std::vector<Vec2> &points, double inkWidth, const Rgba &colour);
/// A part of an ellipse, angles clockwise from the right.
std::vector<Vec2> arcPoints(const Vec2 &middle, double rx, double ry, double from = 0.0,
                            double to = 2.0 * std::numbers::pi);

/// Puts \a mark on top of a drawing; asserts that it is a sound one.
void draw(Canvas &canvas, int drawing, DoodleMark mark);
void addCanvas(DoodleScene &scene, Canvas canvas);

} // namespace ductus
