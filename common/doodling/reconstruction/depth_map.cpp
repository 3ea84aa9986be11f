#include "doodling/reconstruction/depth_map.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

// Neighbours that differ by a larger share belong to different things.
constexpr double silhouetteShare = 0.08;

} // namespace

std::size_t DepthMap::cellAt(const Eigen::Vector2d &pixel) const
{
    const int x = int(std::clamp(pixel.x() / cellSize, 0.0, double(width - 1)));
    const int y = int(std::clamp(pixel.y() / cellSize, 0.0, double(height - 1)));
    return std::size_t(y) * std::size_t(width) + std::size_t(x);
}

double DepthMap::depthAt(const Eigen::Vector2d &pixel) const
{
    const double x = std::clamp(pixel.x() / cellSize - 0.5, 0.0, double(width - 1));
    const double y = std::clamp(pixel.y() / cellSize - 0.5, 0.0, double(height - 1));
    const int x0 = int(x), y0 = int(y);
    const int x1 = std::min(x0 + 1, width - 1), y1 = std::min(y0 + 1, height - 1);
    const auto at = [&](int cx, int cy) {
        return cellDisparity(std::size_t(cy) * std::size_t(width) + std::size_t(cx));
    };
    const double a = at(x0, y0), b = at(x1, y0), c = at(x0, y1), d = at(x1, y1);
    const double least = std::min({a, b, c, d}), most = std::max({a, b, c, d});
    if (most - least > silhouetteShare * most)
        return 1.0 / cellDisparity(cellAt(pixel));
    const double fx = x - x0, fy = y - y0;
    return 1.0 / ((a * (1 - fx) + b * fx) * (1 - fy) + (c * (1 - fx) + d * fx) * fy);
}

int DepthMap::objectAt(const Eigen::Vector2d &pixel) const
{
    return objects.empty() ? 0 : objects[cellAt(pixel)];
}

DepthMap depthMapOf(int width, int height, double cellSize, std::span<const float> disparities)
{
    DepthMap map;
    map.width = width;
    map.height = height;
    map.cellSize = cellSize;
    float most = 0.0f;
    for (float disparity : disparities)
        if (std::isfinite(disparity))
            most = std::max(most, disparity);
    map.mostDisparity = most > 0.0f ? double(most) : 1.0;
    std::vector<std::uint16_t> packed;
    packed.reserve(disparities.size());
    for (float disparity : disparities) {
        const double steps = std::isfinite(disparity) ? disparity / map.mostDisparity * 65535.0 : 1.0;
        packed.push_back(std::uint16_t(std::clamp(std::round(steps), 1.0, 65535.0)));
    }
    map.disparities = std::move(packed);
    return map;
}

} // namespace ductus
