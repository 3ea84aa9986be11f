#include "surfacing/segmentation/model_fit.h"

#include "base/assert.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace ductus {

ImplicitPolynomial fitPolynomial(const std::vector<OrientedPoint> &points, std::span<const int> subset,
                                 int degree, const ModelFitOptions &options)
{
    return fitPolynomial(points, subset, points, subset, degree, options);
}

ImplicitPolynomial fitPolynomial(const std::vector<OrientedPoint> &points, std::span<const int> subset,
                                 const std::vector<OrientedPoint> &directions,
                                 std::span<const int> directionSubset, int degree,
                                 const ModelFitOptions &options)
{
    if (directionSubset.empty())
        return fitPolynomial(points, subset, points, subset, degree, options);
    DUCTUS_ASSERT(!subset.empty());
    const int t = monomialCount(degree);
    const int n = int(subset.size()), k = int(directionSubset.size());

    ImplicitPolynomial model;
    model.degree = degree;
    for (int i : subset)
        model.origin += points[std::size_t(i)].point / n;

    // M: n x t monomials; B: k x t alignment rows n_p^T grad X(p).
    Eigen::MatrixXd M(n, t), B(k, t);
    double m[maxMonomialCount], dx[maxMonomialCount], dy[maxMonomialCount], dz[maxMonomialCount];
    for (int row = 0; row < n; ++row) {
        evaluateMonomials(points[std::size_t(subset[std::size_t(row)])].point - model.origin, degree, m);
        M.row(row) = Eigen::Map<const Eigen::RowVectorXd>(m, t);
    }
    for (int row = 0; row < k; ++row) {
        const OrientedPoint &p = directions[std::size_t(directionSubset[std::size_t(row)])];
        evaluateMonomials(p.point - model.origin, degree, m, dx, dy, dz);
        for (int j = 0; j < t; ++j)
            B(row, j) = p.normal.x() * dx[j] + p.normal.y() * dy[j] + p.normal.z() * dz[j];
    }

    Eigen::VectorXd mean = Eigen::VectorXd::Zero(t), scale = Eigen::VectorXd::Ones(t);
    for (int j = 1; j < t; ++j) {
        mean[j] = M.col(j).mean();
        // A column without spread (points in a coordinate plane) keeps a tiny one instead of a division by
        // zero.
        scale[j] = std::max(std::sqrt((M.col(j).array() - mean[j]).square().mean()), 1e-9);
        M.col(j) = (M.col(j).array() - mean[j]) / scale[j];
        B.col(j) /= scale[j];
    }

    const double mu = options.alignment * options.boost * n / k;
    const double lambda = options.regularisation * options.boost;
    Eigen::MatrixXd normalMatrix = M.transpose() * M + mu * (B.transpose() * B);
    normalMatrix.diagonal().array() += lambda;
    const Eigen::VectorXd hat = normalMatrix.ldlt().solve(mu * B.colwise().sum().transpose());

    model.theta = hat.cwiseQuotient(scale);
    model.theta[0] -= mean.tail(t - 1).dot(model.theta.tail(t - 1));
    return model;
}

} // namespace ductus
