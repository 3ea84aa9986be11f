// Where what is in each cell of a frame is in the frames before and after: flow followed step by step while
// it is trusted.
#pragma once

#include "doodling/reconstruction/shot.h"

namespace ductus {

/// All places of one frame in another one; row by row in the cells of the flow.
struct ChainedPlaces
{
    int frame = 0;
    std::vector<Eigen::Vector2f> pixels;
    std::vector<float> trusts; // 0: lost on the way; else the least confidence so far
};

struct ChainOptions
{
    float leastConfidence = 0.35f;
    int everyFrame = 1; // which of the frames on the way are kept
};

/// From \a frame to \a frame + steps (steps may be negative), cut at the ends of the clip.
std::vector<ChainedPlaces> chainedFrom(const Shot &shot, int frame, int steps,
                                       const ChainOptions &options = {});

} // namespace ductus
