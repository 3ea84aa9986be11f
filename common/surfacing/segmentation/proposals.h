// New models at the end of each round of Algorithm 1 (thesis Sec. III.5.3, New model proposal): the same regions
// with lower degrees, and unions of neighbouring regions, pairs with much uncrossed border between them first.
//
// The thesis goes down one degree a round and merges at one degree. A flat face seen as two quartics then stays so:
// each step down must lower the energy by itself, and the cubic in between seldom does. With expansions this cheap all
// lower degrees are offered at once.
#pragma once

#include "surfacing/segmentation/segmentation.h"

#include <set>

namespace ductus {

/// Pairs of regions tried before, told by the numbers of points they had: not proposed again.
using TriedMerges = std::set<std::pair<std::size_t, std::size_t>>;

std::vector<ImplicitPolynomial> proposeModels(const Association &association, const MeshTopology &topology,
                                              const std::vector<int> &labels,
                                              const std::vector<ImplicitPolynomial> &models,
                                              const SegmentationOptions &options, TriedMerges &tried);

} // namespace ductus
