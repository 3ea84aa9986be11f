// The first surface models: one a spectral cluster of the proxy, at several numbers of clusters, fitted with
// boosted regularisation (thesis Sec. III.5.3, Initialization).
#pragma once

#include "base/random.h"
#include "surfacing/segmentation/segmentation.h"

#include <Eigen/Core>

namespace ductus {

/// Eigenvectors of the proxy graph, shared by all runs: edges no stroke crosses hold their ends together.
Result<Eigen::MatrixXd> proxyEmbedding(const Association &association, const MeshTopology &topology,
                                       const SegmentationOptions &options, const JobControl &control);

std::vector<ImplicitPolynomial> initialModels(const Association &association, const Eigen::MatrixXd &embedding,
                                              const SegmentationOptions &options, Random random);

} // namespace ductus
