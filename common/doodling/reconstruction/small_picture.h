// A frame as small as tracking can do with: lightness at half its size, colour at a quarter, in CIE Lab, so
// that a minute of film stays in memory and differences weigh as they are seen.
#pragma once

#include "doodling/cache/shared_array.h"
#include "imaging/image.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace ductus {

struct SmallPicture
{
    int width = 0, height = 0;             // of lightness: half the picture's, at least 1
    SharedArray<std::uint8_t> lightness;   // L * 2.55; row by row
    int colourWidth = 0, colourHeight = 0; // a quarter of the picture's
    SharedArray<std::uint8_t> colours;     // a + 128, b + 128

    bool isEmpty() const { return lightness.empty(); }
    /// L, a, b in 0..255 between pixels; places outside count as the border. \a pixel of the whole picture.
    Eigen::Vector3f labAt(const Eigen::Vector2d &pixel) const;
};

SmallPicture smallPictureOf(const Image &image);

} // namespace ductus
