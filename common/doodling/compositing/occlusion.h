// Where what is filmed hides a canvas (thesis VI.6.3; doodles.md section 1): the depth of the scene against
// the canvas' plane, with a bias and a soft band, made to follow the picture's edges; then the user's brush.
#pragma once

#include "doodling/canvas/canvas.h"
#include "doodling/compositing/coverage.h"

#include <functional>

namespace ductus {

/// How much of the canvas is seen, 0..1, one value a pixel of \a box, row by row; empty: all of it.
/// \a view in pixels of \a picture, the shot's frame \a frame at any size.
std::vector<float> visibilityOf(const CanvasOcclusion &occlusion, const Shot &shot, int frame,
                                const CanvasView &view, const Image &picture, const PixelBox &box);

/// Along the camera's axis at a pixel of the picture, scene units; 0 or less where nothing can hide it.
using DepthOfShown = std::function<double(const Vec2 &pixel)>;

/// The same for what is no sheet.
std::vector<float> visibilityOf(const CanvasOcclusion &occlusion, const Shot &shot, int frame,
                                const DepthOfShown &depthOf, const Image &picture, const PixelBox &box);

/// A touch's line as it is in frame \a frame: carried along by the flow, step by step. Working pixels.
std::vector<Vec2> carriedLine(const OcclusionTouch &touch, const Shot &shot, int frame);

} // namespace ductus
