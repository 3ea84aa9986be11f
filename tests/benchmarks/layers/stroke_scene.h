// A painting of many strokes, as a painter's: a ground of strokes that are the shape, the rest in layers that
// colour it.
#pragma once

#include "painting/reference/frame_camera.h"
#include "painting/scene/painting.h"

namespace ductus {

struct StrokeScene
{
    Painting painting;
    FrameCamera camera; // for square pictures, all of it in view
};

/// Half of \a strokes are the ground, half in \a layers appearance layers above it; with \a layers 0 all are
/// ground. The same strokes at the same places, 12 points each. \a size is the side of the square they cover.
StrokeScene strokeScene(int strokes, int layers, std::uint64_t seed, double size = 2);

} // namespace ductus
