// Where the parts of a picture are found again in another one, however far they went: small windows compared
// from coarse to fine, good finds handed on to neighbours and varied at random [Barnes 2009, PatchMatch; Hu
// 2016, coarse-to-fine PatchMatch]. Right to some pixels, and gives the exact flow a start where a thing
// moves further than its own width, where flow by itself stays with what is behind it.
#pragma once

#include "imaging/image.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace ductus {

/// What the windows of a picture look like, at half its size and at each half of that.
struct WindowPyramid
{
    struct Level
    {
        int width = 0, height = 0;
        std::vector<std::uint8_t> windows; // windowNumbers a pixel, row by row
    };
    static constexpr int windowNumbers = 72; // 3 x 3 places, edges in four directions, lightness, colour
    std::vector<Level> levels;               // finest first
    int width = 0, height = 0;               // of the picture
};

WindowPyramid windowPyramidOf(const Image &image);

/// Motions on a grid of \a cellSize pixels, row by row. Cells whose motion there and back does not come home
/// have that of the nearest cell where it does.
struct RoughMotion
{
    int width = 0, height = 0;
    double cellSize = 8.0;
    std::vector<Eigen::Vector2f> motions; // pixels of the picture
    double surenessShare = 0.0;           // of the cells that came home
};

struct RoughMotionPair
{
    RoughMotion forward, backward;
};

/// Between pictures of one size. The same for the same pictures, whatever the machine.
RoughMotionPair roughMotion(const WindowPyramid &from, const WindowPyramid &to);

} // namespace ductus
