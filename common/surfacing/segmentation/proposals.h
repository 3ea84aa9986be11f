// New models at the end of each round of Algorithm 1 (thesis Sec. III.5.3, New model proposal): the same regions
// with one degree less, and unions of neighbouring regions, pairs with much uncrossed border between them first.
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
