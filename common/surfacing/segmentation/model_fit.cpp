#include "surfacing/segmentation/model_fit.h"

#include "base/assert.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace ductus {

ImplicitPolynomial fitPolynomial(const std::vector<OrientedPoint> &points, std::span<const int> subset, int degree,
                                 const ModelFitOptions &options)
{
    DUCTUS_ASSERT(!subset.empty());
    const int t = monomialCount(degree);
    const int n = int(subset.size());

    ImplicitPolynomial model;
    model.degree = degree;
    for (int i : subset)
        model.origin += points[std::size_t(i)].point / n;

    // M: n x t monomials; B: n x t alignment rows n_p^T grad X(p).
    Eigen::MatrixXd M(n, t), B(n, t);
    double m[maxMonomialCount], dx[maxMonomialCount], dy[maxMonomialCount], dz[maxMonomialCount];
    for (int row = 0; row < n; ++row) {
        const OrientedPoint &p = points[std::size_t(subset[std::size_t(row)])];
        evaluateMonomials(p.point - model.origin, degree, m, dx, dy, dz);
        for (int k = 0; k < t; ++k) {
            M(row, k) = m[k];
            B(row, k) = p.normal.x() * dx[k] + p.normal.y() * dy[k] + p.normal.z() * dz[k];
        }
    }

    Eigen::VectorXd mean = Eigen::VectorXd::Zero(t), scale = Eigen::VectorXd::Ones(t);
    for (int k = 1; k < t; ++k) {
        mean[k] = M.col(k).mean();
        // A column without spread (points in a coordinate plane) keeps a tiny one instead of a division by zero.
        scale[k] = std::max(std::sqrt((M.col(k).array() - mean[k]).square().mean()), 1e-9);
        M.col(k) = (M.col(k).array() - mean[k]) / scale[k];
        B.col(k) /= scale[k];
    }

    const double mu = options.alignment * options.boost;
    const double lambda = options.regularisation * options.boost;
    Eigen::MatrixXd normalMatrix = M.transpose() * M + mu * (B.transpose() * B);
    normalMatrix.diagonal().array() += lambda;
    const Eigen::VectorXd hat = normalMatrix.ldlt().solve(mu * B.colwise().sum().transpose());

    model.theta = hat.cwiseQuotient(scale);
    model.theta[0] -= mean.tail(t - 1).dot(model.theta.tail(t - 1));
    return model;
}

} // namespace ductus
