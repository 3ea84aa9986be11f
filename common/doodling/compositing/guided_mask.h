// A coarse mask made to follow the edges of a picture, as fine as that is.
#pragma once

#include "doodling/compositing/coverage.h"

namespace ductus {

/// A mask over a grid that covers a box of the picture: cell (x, y) has its middle at
/// (left + (x + 0.5) * cellSize, top + (y + 0.5) * cellSize).
struct CoarseMask
{
    int width = 0, height = 0;
    double left = 0.0, top = 0.0, cellSize = 1.0; // pixels of the picture
    std::vector<float> values;                    // 0..1, row by row
};

struct GuideOptions
{
    int radius = 4;        // cells: over so many to each side colours are compared
    int reach = 3;         // cells: how far a mask's edge may lie beside the picture's
    double epsilon = 4e-4; // squared differences of colour (0..1) that count as an edge
};

/// One value a pixel of \a box: the mask as a local linear function of the picture's colours, found on the
/// coarse grid and applied at full size [guided filter, He 2013; fast form, He 2015].
std::vector<float> guidedMask(const CoarseMask &mask, const Image &picture, const PixelBox &box,
                              const GuideOptions &options = {});

} // namespace ductus
