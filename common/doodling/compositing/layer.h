// Doodles painted over nothing: colours with their share of the pixel, above each other.
#pragma once

#include "doodling/compositing/coverage.h"

namespace ductus {

/// A part of a picture, colours multiplied by alpha, 0..1; four floats a pixel, row by row.
struct PaintedLayer
{
    PixelBox box;
    std::vector<float> pixels;

    float *at(int x, int y)
    {
        return pixels.data() +
               4 * (std::size_t(y - box.top) * std::size_t(box.width()) + std::size_t(x - box.left));
    }
    const float *at(int x, int y) const { return const_cast<PaintedLayer *>(this)->at(x, y); }
};

/// \a pieces in their order, lowest first, as seen by \a view, as far as they are within \a limits.
PaintedLayer paintedPieces(const std::vector<MarkPiece> &pieces, const CanvasView &view,
                           const PixelBox &limits);

/// Lays \a layer over \a picture. A picture that is not opaque keeps straight alpha.
void layOver(const PaintedLayer &layer, Image &picture);

} // namespace ductus
