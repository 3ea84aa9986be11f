#include "doodling/tracking/depth_along.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr double leastWeight = 1e-6; // keeps the system definite where nothing is measured

SparseMatrix stiffnessOf(int count, double stiffness)
{
    std::vector<Eigen::Triplet<double>> entries;
    const double share[3] = {1.0, -2.0, 1.0};
    for (int t = 1; t + 1 < count; ++t)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                entries.emplace_back(t - 1 + i, t - 1 + j, stiffness * share[i] * share[j]);
    SparseMatrix matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

} // namespace

std::vector<double> smoothedDepths(const std::vector<MeasuredDepth> &measured, const DepthSmoothing &options)
{
    const int count = int(measured.size());
    Eigen::VectorXd logs(count), weights(count);
    for (int t = 0; t < count; ++t) {
        logs[t] = std::log(std::max(measured[std::size_t(t)].depth, 1e-12));
        weights[t] = std::max(measured[std::size_t(t)].weight, leastWeight);
    }
    const SparseMatrix stiff = stiffnessOf(count, options.stiffness);
    Eigen::VectorXd smooth = logs, robust = weights;
    for (int round = 0; round < options.rounds; ++round) {
        SparseMatrix system = stiff;
        for (int t = 0; t < count; ++t)
            system.coeffRef(t, t) += robust[t];
        smooth = Eigen::SimplicialLDLT<SparseMatrix>(system).solve(robust.cwiseProduct(logs));
        for (int t = 0; t < count; ++t)
            robust[t] = weights[t] / (1.0 + std::pow((logs[t] - smooth[t]) / options.outlierShare, 2));
    }
    std::vector<double> depths;
    for (int t = 0; t < count; ++t)
        depths.push_back(std::exp(smooth[t]));
    return depths;
}

} // namespace ductus
