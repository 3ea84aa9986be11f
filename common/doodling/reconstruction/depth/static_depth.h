// How far away each cell of a frame is if it stands still, from where flow leads it in the frames around and
// the cameras there; and how badly standing still explains it.
#pragma once

#include "doodling/reconstruction/shot.h"

namespace ductus {

struct StaticDepth
{
    std::vector<float> inverseDepths; // one a cell of the flow; 1 / scene unit
    std::vector<float> spreads;       // standard deviation of the inverse depth; infinite: nothing is known
    std::vector<float> misses;        // pixels: what no depth explains; negative: never seen again
};

struct StaticDepthOptions
{
    double enoughParallax = 12.0; // pixels: chains end where the usual depth shows so much
    int longestChain = 24;        // frames each way
    int mostSightings = 5;        // each way
    double placeSpread = 0.35;    // pixels, of a flow step
};

/// \a usualInverseDepth is where the search starts, and says how much parallax is to be expected.
StaticDepth staticDepth(const Shot &shot, int frame, double usualInverseDepth,
                        const StaticDepthOptions &options = {});

} // namespace ductus
