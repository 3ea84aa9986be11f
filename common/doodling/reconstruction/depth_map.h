// How far away what a frame shows is, and which of it moves by itself. A grid over the picture like a flow
// field's, in 16 bits of disparity (1 / depth): as fine near the camera as is seen, and infinity is a number.
#pragma once

#include "doodling/cache/shared_array.h"

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace ductus {

/// Cell (x, y) has its middle at ((x + 0.5) * cellSize, (y + 0.5) * cellSize); row by row.
struct DepthMap
{
    int width = 0, height = 0;              // cells
    double cellSize = 1.0;                  // pixels of the picture
    double mostDisparity = 1.0;             // what 65535 stands for; 1 / scene unit
    SharedArray<std::uint16_t> disparities; // 0 is never stored: depths are finite
    SharedArray<std::uint8_t> objects;      // 0 stands still, else the number of what moves; none: all 0

    bool isEmpty() const { return disparities.empty(); }
    /// Between cells by their four neighbours, across silhouettes the nearest cell's: what lies between two
    /// things is neither. Places outside count as the border. Depth along z, scene units.
    double depthAt(const Eigen::Vector2d &pixel) const;
    /// The number of what moves by itself there, 0 for what stands still.
    int objectAt(const Eigen::Vector2d &pixel) const;

    double cellDisparity(std::size_t cell) const { return disparities[cell] * mostDisparity / 65535.0; }
    std::size_t cellAt(const Eigen::Vector2d &pixel) const;
};

/// From disparities in 1 / scene unit, one a cell; what is not positive and finite becomes the smallest.
DepthMap depthMapOf(int width, int height, double cellSize, std::span<const float> disparities);

} // namespace ductus
