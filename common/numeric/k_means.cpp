#include "numeric/k_means.h"

#include "base/parallel.h"

#include <algorithm>
#include <limits>

namespace ductus {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t pointsPerChunk = 256;

// Index drawn with probability proportional to weights; the last positive one where rounding overshoots.
Index draw(const VectorXd &weights, Random &random)
{
    double rest = random.uniform() * weights.sum();
    Index last = 0;
    for (Index i = 0; i < weights.size(); ++i) {
        if (weights[i] <= 0.0)
            continue;
        last = i;
        rest -= weights[i];
        if (rest < 0.0)
            break;
    }
    return last;
}

MatrixXd seedCentres(const MatrixXd &points, int clusterCount, Random &random)
{
    MatrixXd centres(points.rows(), clusterCount);
    VectorXd distances = VectorXd::Constant(points.cols(), std::numeric_limits<double>::infinity());
    Index chosen = random.index(int(points.cols()));
    for (int cluster = 0; cluster < clusterCount; ++cluster) {
        centres.col(cluster) = points.col(chosen);
        parallelChunks(std::size_t(points.cols()), pointsPerChunk, [&](std::size_t begin, std::size_t end) {
            for (Index i = Index(begin); i < Index(end); ++i)
                distances[i] = std::min(distances[i], (points.col(i) - centres.col(cluster)).squaredNorm());
        });
        // All points taken: the remaining clusters stay empty copies.
        chosen = distances.maxCoeff() > 0.0 ? draw(distances, random) : 0;
    }
    return centres;
}

// |p - c|^2 = |p|^2 - 2 (p.c - |c|^2 / 2): the nearest centre has the largest bracket. Returns how many
// changed.
int assign(const MatrixXd &points, const MatrixXd &centres, std::vector<int> &clusters)
{
    const VectorXd offsets = 0.5 * centres.colwise().squaredNorm().transpose();
    const std::size_t count = std::size_t(points.cols());
    std::vector<int> changed((count + pointsPerChunk - 1) / pointsPerChunk, 0);
    parallelChunks(count, pointsPerChunk, [&](std::size_t begin, std::size_t end) {
        const MatrixXd scores =
            (centres.transpose() * points.middleCols(Index(begin), Index(end - begin))).colwise() - offsets;
        for (std::size_t i = begin; i < end; ++i) {
            Index best = 0;
            for (Index cluster = 1; cluster < scores.rows(); ++cluster) {
                if (scores(cluster, Index(i - begin)) > scores(best, Index(i - begin)))
                    best = cluster;
            }
            changed[begin / pointsPerChunk] += clusters[i] != int(best);
            clusters[i] = int(best);
        }
    });
    int total = 0;
    for (int n : changed)
        total += n;
    return total;
}

// Empty clusters keep their centre.
void moveCentres(const MatrixXd &points, const std::vector<int> &clusters, MatrixXd &centres)
{
    MatrixXd sums = MatrixXd::Zero(centres.rows(), centres.cols());
    std::vector<int> counts(std::size_t(centres.cols()), 0);
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        sums.col(clusters[i]) += points.col(Index(i));
        ++counts[clusters[i]];
    }
    for (Index cluster = 0; cluster < centres.cols(); ++cluster) {
        if (counts[cluster] > 0)
            centres.col(cluster) = sums.col(cluster) / counts[cluster];
    }
}

} // namespace

std::vector<int> kMeans(const MatrixXd &points, int clusterCount, Random random, const KMeansOptions &options)
{
    std::vector<int> clusters(std::size_t(points.cols()), 0);
    if (clusterCount < 2 || points.cols() == 0)
        return clusters;
    MatrixXd centres = seedCentres(points, clusterCount, random);
    const int enough = int(options.changedShare * double(points.cols()));
    for (int iteration = 0; iteration < options.maxIterations; ++iteration) {
        if (assign(points, centres, clusters) <= enough && iteration > 0)
            break;
        moveCentres(points, clusters, centres);
    }
    return clusters;
}

} // namespace ductus
