// A few clearly different answers to choose from: segmentations nearly as good as the best, with other
// borders.
#pragma once

#include "surfacing/ambiguity/label_samples.h"

namespace ductus {

struct AlternativeOptions
{
    int count = 3;                 // at most
    double worstEnergy = 1.3;      // of an alternative, against the energy of the reference
    double leastDifference = 0.2;  // from the reference and from one another, see borderDifference
    double borderTolerance = 0.02; // borders this near to one another are the same, share of the box diagonal
};

/// Length, in box diagonals, of the borders of either that have none of the other within \a tolerance.
double borderDifference(const TriangleMesh &proxy, const MeshTopology &topology, const std::vector<int> &a,
                        const std::vector<int> &b, double tolerance);

/// Indices into \a samples, each time the one that differs most from \a reference and from those chosen
/// before. The energy of \a reference is of the same options as those of the samples.
std::vector<int> alternatives(const TriangleMesh &proxy, const MeshTopology &topology,
                              const Segmentation &reference, const std::vector<LabelSample> &samples,
                              const AlternativeOptions &options);

} // namespace ductus
