#include "doodling/reconstruction/depth/edge_aware_smoothing.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

using Colour = std::array<float, 3>;

std::vector<Colour> cellColours(const Image &image, int cellSize, int width, int height)
{
    std::vector<Colour> colours;
    colours.reserve(std::size_t(width) * std::size_t(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            Colour sum = {0.0f, 0.0f, 0.0f};
            int count = 0;
            for (int py = y * cellSize; py < std::min(image.height, (y + 1) * cellSize); ++py)
                for (int px = x * cellSize; px < std::min(image.width, (x + 1) * cellSize); ++px) {
                    const std::uint8_t *pixel =
                        image.pixels.data() +
                        4 * (std::size_t(py) * std::size_t(image.width) + std::size_t(px));
                    for (std::size_t c = 0; c < 3; ++c)
                        sum[c] += pixel[c];
                    ++count;
                }
            for (float &channel : sum)
                channel /= float(std::max(1, count));
            colours.push_back(sum);
        }
    return colours;
}

float likeness(const Colour &a, const Colour &b, double sigma)
{
    float most = 0.0f;
    for (std::size_t c = 0; c < 3; ++c)
        most = std::max(most, std::abs(a[c] - b[c]));
    return float(std::exp(-double(most) / sigma)) + 1e-4f;
}

// Two numbers a cell are smoothed alike: the weighted value and the weight.
struct Pair
{
    float value = 0.0f, weight = 0.0f;
};

// (1 + lambda L) u = f along one row or column by elimination and back substitution.
void smoothLine(Pair *cells, std::size_t stride, const float *edges, std::size_t edgeStride, int count,
                float lambda, std::vector<float> &upper)
{
    upper.resize(std::size_t(count));
    float before = 0.0f; // weight of the edge to the cell before
    for (int i = 0; i < count; ++i) {
        const float after = i + 1 < count ? lambda * edges[std::size_t(i) * edgeStride] : 0.0f;
        Pair &cell = cells[std::size_t(i) * stride];
        float diagonal = 1.0f + before + after;
        if (i > 0) {
            const Pair &last = cells[std::size_t(i - 1) * stride];
            diagonal -= before * upper[std::size_t(i) - 1];
            cell.value += before * last.value;
            cell.weight += before * last.weight;
        }
        upper[std::size_t(i)] = after / diagonal;
        cell.value /= diagonal;
        cell.weight /= diagonal;
        before = after;
    }
    for (int i = count - 1; i-- > 0;) {
        Pair &cell = cells[std::size_t(i) * stride];
        const Pair &next = cells[std::size_t(i + 1) * stride];
        cell.value += upper[std::size_t(i)] * next.value;
        cell.weight += upper[std::size_t(i)] * next.weight;
    }
}

} // namespace

EdgeWeights edgeWeights(const Image &image, int cellSize, double sigma)
{
    EdgeWeights edges;
    edges.width = (image.width + cellSize - 1) / cellSize;
    edges.height = (image.height + cellSize - 1) / cellSize;
    const std::vector<Colour> colours = cellColours(image, cellSize, edges.width, edges.height);
    const std::size_t width = std::size_t(edges.width);
    edges.right.assign(colours.size(), 0.0f);
    edges.down.assign(colours.size(), 0.0f);
    for (std::size_t y = 0; y < std::size_t(edges.height); ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = y * width + x;
            if (x + 1 < width)
                edges.right[i] = likeness(colours[i], colours[i + 1], sigma);
            if (y + 1 < std::size_t(edges.height))
                edges.down[i] = likeness(colours[i], colours[i + width], sigma);
        }
    return edges;
}

std::vector<float> smoothed(const EdgeWeights &edges, std::span<const float> values,
                            std::span<const float> weights, const SmoothingOptions &options)
{
    std::vector<Pair> cells(values.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i] = {values[i] * weights[i], weights[i]};
    const std::size_t width = std::size_t(edges.width);
    std::vector<float> upper;
    const double all = std::pow(4.0, options.rounds) - 1.0;
    for (int round = 1; round <= options.rounds; ++round) {
        // Less in each round, so that no streaks stay.
        const float lambda = float(1.5 * std::pow(4.0, options.rounds - round) / all * options.lambda);
        for (int y = 0; y < edges.height; ++y)
            smoothLine(cells.data() + std::size_t(y) * width, 1, edges.right.data() + std::size_t(y) * width,
                       1, edges.width, lambda, upper);
        for (int x = 0; x < edges.width; ++x)
            smoothLine(cells.data() + x, width, edges.down.data() + x, width, edges.height, lambda, upper);
    }
    std::vector<float> result;
    result.reserve(cells.size());
    for (const Pair &cell : cells)
        result.push_back(cell.weight > 1e-12f ? cell.value / cell.weight : 0.0f);
    return result;
}

} // namespace ductus
