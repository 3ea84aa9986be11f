// How much of each pixel a shape covers, for shapes on a canvas seen in perspective.
#pragma once

#include "doodling/canvas/canvas_view.h"
#include "doodling/compositing/mark_pieces.h"

namespace ductus {

/// A rectangle of pixels: left..right-1, top..bottom-1.
struct PixelBox
{
    int left = 0, top = 0, right = 0, bottom = 0;

    bool isEmpty() const { return left >= right || top >= bottom; }
    int width() const { return right - left; }
    int height() const { return bottom - top; }
    PixelBox within(const PixelBox &other) const;
    PixelBox joined(const PixelBox &other) const;
};

/// Shares of pixels covered, 0..1, row by row.
struct Coverage
{
    PixelBox box;
    std::vector<float> shares;
};

/// The pixels within \a limits a piece may touch.
PixelBox boxOf(const MarkPiece &piece, const CanvasView &view, const PixelBox &limits);

/// Of round strokes: brushes are circles on the canvas and so ellipses in the picture. Exact for lines that
/// are straight across a pixel; strokes thinner than a pixel fade.
Coverage lineCoverage(const LinePiece &piece, const CanvasView &view, const PixelBox &limits);

/// Of what outlines go round: exact areas [as font rasterisers accumulate them], |winding number| cut at 1.
Coverage areaCoverage(const AreaPiece &piece, const CanvasView &view, const PixelBox &limits);

} // namespace ductus
