// k-means: k-means++ seeding [Arthur, Vassilvitskii 2007] and Lloyd's iteration.
#pragma once

#include "base/random.h"

#include <Eigen/Core>
#include <vector>

namespace ductus {

struct KMeansOptions
{
    int maxIterations = 60;
    double changedShare = 1e-4; // ends when fewer points than this share change their cluster
};

/// Cluster of each column of \a points, 0 .. clusterCount-1 (all 0 for a count below 1; clusters may be empty
/// when points coincide). Ties go to the lower cluster; the result does not depend on the number of cores.
std::vector<int> kMeans(const Eigen::MatrixXd &points, int clusterCount, Random random,
                        const KMeansOptions &options = {});

} // namespace ductus
