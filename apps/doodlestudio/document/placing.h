// Placing canvases by hand: from where the pointer is on a frame to a canvas, or to the next keyframe of one.
// All pixels are working pixels.
#pragma once

#include "doodling/canvas/canvas.h"
#include "doodling/canvas/canvas_view.h"

namespace ductus {

/// A standing canvas that fills the box between two corners in \a frame, lies at the depth of what is seen at
/// its middle and faces the camera. Boxes smaller than a click count as one: the canvas is as large as suits
/// the picture.
Canvas canvasInBox(const Shot &shot, int frame, const Vec2 &corner, const Vec2 &opposite,
                   const std::string &name);

/// \a prop on a standing canvas that fills such a box, upright on the box' lower edge, facing the camera. \a
/// distance along the camera's axis, scene units; none: that of what is seen where it stands.
Canvas propInBox(const Shot &shot, int frame, const Vec2 &corner, const Vec2 &opposite, Prop prop,
                 std::optional<double> distance);

/// The canvas with its middle at \a pixel in \a frame. Moving ones get a keyframe there; standing ones are
/// put there.
Result<Canvas> withMiddleAt(const Canvas &canvas, int frame, const Vec2 &pixel);

/// The same for how it is turned, its distance and its size (1: as it was made).
Result<Canvas> withTurnAt(const Canvas &canvas, int frame, const Eigen::Quaterniond &worldFromCanvas);
Result<Canvas> withDistanceAt(const Canvas &canvas, int frame, double depth);
Result<Canvas> withScaleAt(const Canvas &canvas, int frame, double scale);
/// The scene's distance counts again.
Canvas withSceneDistance(const Canvas &canvas);

/// Pinned to what is under its middle in \a frame, or left standing where \a place says it is in \a frame.
Canvas following(const Canvas &canvas, int frame, const CanvasFrame &place);
Canvas standingAt(const Canvas &canvas, int frame, const CanvasFrame &place);

/// Tilted so that its front looks along \a towardsCamera (camera axes, unit length, z < 0), without turning
/// in its own plane more than needed.
Eigen::Quaterniond tilted(const Eigen::Quaterniond &worldFromCanvas, const ShotCamera &camera,
                          const Vec3 &towardsCamera);
/// Turned clockwise in its own plane.
Eigen::Quaterniond spun(const Eigen::Quaterniond &worldFromCanvas, double radians);
/// Its front in camera axes, unit length.
Vec3 frontInCamera(const Eigen::Quaterniond &worldFromCanvas, const ShotCamera &camera);

} // namespace ductus
