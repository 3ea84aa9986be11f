// Depth of what stands still in one frame: measured where the flow tells, spread from there over what looks
// alike, and mixed with what the frame before said.
#pragma once

#include "doodling/reconstruction/depth/edge_aware_smoothing.h"
#include "doodling/reconstruction/shot.h"

#include <span>

namespace ductus {

/// What one frame tells without the ones before; cells row by row.
struct StillFrame
{
    EdgeWeights edges;
    std::vector<float> inverseDepths; // measured; 1 / scene unit
    std::vector<float> weights;       // 0..1, how far that is to be believed
    std::vector<float> wide;          // what lies around
};

/// \a objects as numberedObjects gives them: 0 for what stands still. For solved cameras.
StillFrame stillFrame(const Shot &shot, int frame, EdgeWeights edges, std::span<const std::uint8_t> objects);

/// Disparities of the frame. \a before are those of the frame before, empty for the first.
std::vector<float> stillDisparities(const Shot &shot, int frame, const StillFrame &still,
                                    std::span<const std::uint8_t> objects, std::span<const float> before);

} // namespace ductus
