// Depths along a track: what depth maps say of its pixels, without their jitter and without what passes in
// front. A canvas is drawn as large as its depth says, so jitter in depth is seen as a trembling size.
#pragma once

#include <vector>

namespace ductus {

struct MeasuredDepth
{
    double depth = 1.0;  // scene units, > 0
    double weight = 1.0; // >= 0; small where the point is hidden
};

struct DepthSmoothing
{
    double stiffness = 20.0;    // against changes of the rate of change: evens out a dozen frames
    double outlierShare = 0.05; // of the depth: a measurement so far off counts half
    int rounds = 5;
};

/// One depth a frame, > 0: least squares on the logarithm with outliers reweighted.
std::vector<double> smoothedDepths(const std::vector<MeasuredDepth> &measured,
                                   const DepthSmoothing &options = {});

} // namespace ductus
