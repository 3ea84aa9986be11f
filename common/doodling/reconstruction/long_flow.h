// Motion between frames that are not neighbours. A point that is followed through direct flow over many
// frames at once does not gather the errors of the steps between, and jumps over what hides it for a moment
// [Neoral 2024, multi-flow tracking].
#pragma once

#include "doodling/cache/shared_array.h"
#include "doodling/reconstruction/flow_field.h"

#include <cstdint>
#include <map>

namespace ductus {

/// A flow field in five bytes a cell: what is kept of flow.
struct CompactFlow
{
    static constexpr float stepsAPixel = 32.0f;

    int width = 0, height = 0; // cells
    double cellSize = 1.0;
    SharedArray<std::int16_t> motions;     // x, y in 1/32 pixel
    SharedArray<std::uint8_t> confidences; // of 255

    CompactFlow() = default;
    CompactFlow(const FlowField &flow);

    bool isEmpty() const { return confidences.empty(); }
    std::size_t cellCount() const { return confidences.size(); }
    /// Between cells by their four neighbours; places outside count as the border. Pixels of the picture.
    MotionAt at(const Eigen::Vector2d &pixel) const;
    Eigen::Vector2d motionAt(const Eigen::Vector2d &pixel) const { return at(pixel).motion; }

    Eigen::Vector2f cellMotion(std::size_t cell) const
    {
        return {float(motions[2 * cell]) / stepsAPixel, float(motions[2 * cell + 1]) / stepsAPixel};
    }
    float cellConfidence(std::size_t cell) const { return float(confidences[cell]) / 255.0f; }
    Eigen::Vector2d cellMiddle(std::size_t cell) const
    {
        return {(double(cell % std::size_t(width)) + 0.5) * cellSize,
                (double(cell / std::size_t(width)) + 0.5) * cellSize};
    }
    /// The cell of a pixel; the nearest one for places outside.
    std::size_t cellAt(const Eigen::Vector2d &pixel) const;
};

CompactFlow compacted(const FlowField &flow);
FlowField expanded(const CompactFlow &flow);

struct CompactFlowPair
{
    CompactFlow forward, backward;
};

/// From frame `first` to frame `first + second` of the key, and back.
using LongFlows = std::map<std::pair<int, int>, CompactFlowPair>;

/// The gaps that end at a frame, ascending, in a clip of so many frames. Long clips have the longer
/// gaps from some frames only, so that a minute of film stays in memory.
std::vector<int> longGapsTo(int frame, int frameCount);

/// The gaps there may be.
inline constexpr int longGaps[] = {2, 4, 8, 16};

} // namespace ductus
