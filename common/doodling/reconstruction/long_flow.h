// Motion between frames that are not neighbours. A point that is followed through direct flow over many
// frames at once does not gather the errors of the steps between, and jumps over what hides it for a moment
// [Neoral 2024, multi-flow tracking].
#pragma once

#include "doodling/reconstruction/flow_field.h"

#include <cstdint>
#include <map>

namespace ductus {

/// A flow field in five bytes a cell.
struct CompactFlow
{
    int width = 0, height = 0; // cells
    double cellSize = 1.0;
    std::vector<std::int16_t> motions;     // x, y in 1/32 pixel
    std::vector<std::uint8_t> confidences; // of 255

    MotionAt at(const Eigen::Vector2d &pixel) const;
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
