// A shot made up for tests of tracking: one thing moves to the right before a ground that stands still, with
// the flow as a test wants it told.
#pragma once

#include "doodling/reconstruction/shot.h"
#include "imaging/image.h"

#include <functional>

namespace ductus {

struct ThingShot
{
    int width = 0, height = 0, frames = 0;
    std::function<bool(int frame, double x, double y)> isThing;
    std::function<Rgba(int frame, int x, int y)> colour;
    std::function<float(int frame)>
        toldSpeed; // of the thing, pixels a frame, by the flow from a frame to the next
    std::function<float(int frame)> confidence = {}; // of that on the thing; empty: 1
};

/// Flow one vector a 4 x 4 pixels, forwards and backwards; 0 and sure of it on the ground.
Shot madeShot(const ThingShot &thing);

} // namespace ductus
