// What places look like, one vector for each block of 8 x 8 pixels: colours of its nine parts in Lab, so that
// brightness and colour weigh as they are seen. Made by hand; a network's features may stand here as well
// (doodles.md section 1).
#pragma once

#include "imaging/image.h"

#include <cstdint>
#include <vector>

namespace ductus {

struct FeatureGrid
{
    int width = 0, height = 0; // cells
    int cellSize = 8;          // pixels
    int channels = 0;
    std::vector<std::uint8_t> values; // channels a cell, row by row

    /// Mean squared difference of two cells, of this grid and another one.
    double distance(int cell, const FeatureGrid &other, int otherCell) const;
    /// The cell of a pixel; the nearest one for places outside.
    int cellAt(double x, double y) const;
};

FeatureGrid featuresOf(const Image &image);

} // namespace ductus
