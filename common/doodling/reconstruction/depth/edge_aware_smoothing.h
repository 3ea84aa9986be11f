// Spreads what is known in few cells over a picture, up to the edges of what is seen: weighted least squares
// in rows and columns by turns [Min et al. 2014, fast global smoothing], with a weight for each known value.
#pragma once

#include "imaging/image.h"

#include <span>
#include <vector>

namespace ductus {

/// How alike neighbouring cells look, 0..1; made once a picture.
struct EdgeWeights
{
    int width = 0, height = 0;
    std::vector<float> right, down; // to the next cell in the row, in the column; row by row
};

/// Cells of \a cellSize pixels. \a sigma is the colour difference (0..255, largest channel) at which a
/// neighbour counts 1/e.
EdgeWeights edgeWeights(const Image &image, int cellSize, double sigma);

struct SmoothingOptions
{
    double lambda = 400.0; // how far a weight of 1 reaches: about its root in cells
    int rounds = 3;
};

/// The smoothed values: near those with weight, between them smooth. Where nothing at all is known it is 0.
std::vector<float> smoothed(const EdgeWeights &edges, std::span<const float> values,
                            std::span<const float> weights, const SmoothingOptions &options = {});

} // namespace ductus
