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
    static constexpr int placeNumbers = 8; // edges in four directions, lightness, colour
    static constexpr int placeStep = 3;    // pixels of the level: a window is 3 x 3 places so far apart
    struct Level
    {
        int width = 0, height = 0;
        // placeNumbers a pixel, row by row, with a border of placeStep pixels that repeats the edge.
        std::vector<std::uint8_t> places;

        /// The middle of the window of a pixel.
        const std::uint8_t *placeAt(int x, int y) const
        {
            return places.data() + std::ptrdiff_t(placeNumbers) *
                                       (std::ptrdiff_t(y + placeStep) * rowLength() + x + placeStep);
        }
        std::ptrdiff_t rowLength() const { return width + 2 * placeStep; } // pixels
    };
    std::vector<Level> levels; // finest first
    int width = 0, height = 0; // of the picture
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
