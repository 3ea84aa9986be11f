#include "surfacing/proxy/variational_fit.h"

#include "base/parallel.h"
#include "surfacing/proxy/sphere_descent.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Spectra/SymEigsSolver.h>
#include <cmath>
#include <optional>

namespace ductus {

namespace {

constexpr const char *attempted = "Fitting a smooth surface through the strokes";

// The generalised covariance of values and gradients, values and polynomial eliminated.
struct Covariance
{
    Eigen::MatrixXd K;     // (n+4)^2: values with nugget, bordered by the polynomial
    Eigen::MatrixXd C;     // (n+4) x 3n: values and polynomial against gradients
    Eigen::MatrixXd S;     // 3n x 3n: gradients given zero values (Schur complement)
    Eigen::PartialPivLU<Eigen::MatrixXd> lu; // of K
};

// Rows of C and blocks of the gradient covariance; columns are gradients, all x then all y then all z.
void assemble(const std::vector<Vec3> &p, const Eigen::VectorXd &lambda, double slopeRidge, Covariance &cov)
{
    const Eigen::Index n = Eigen::Index(p.size());
    cov.K.setZero(n + 4, n + 4);
    cov.C.setZero(n + 4, 3 * n);
    cov.S.resize(3 * n, 3 * n);
    parallelFor(0, std::size_t(n), [&](std::size_t column) {
        const Eigen::Index j = Eigen::Index(column);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Vec3 d = p[std::size_t(i)] - p[std::size_t(j)];
            const double r = d.norm();
            cov.K(i, j) = r * r * r;
            for (int k = 0; k < 3; ++k)
                cov.C(i, k * n + j) = -3.0 * r * d[k]; // -d/dx_k of r^3
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) // minus the Hessian of r^3
                    cov.S(k * n + i, l * n + j) =
                        r < 1e-12 ? 0.0 : -3.0 * (d[k] * d[l] / r + (k == l ? r : 0.0));
        }
        cov.K(j, j) += lambda[j];
        cov.K(n, j) = cov.K(j, n) = 1.0;
        for (int k = 0; k < 3; ++k) {
            cov.K(n + 1 + k, j) = cov.K(j, n + 1 + k) = p[column][k];
            cov.C(n + 1 + k, k * n + j) = 1.0;
        }
    });
    for (int k = 0; k < 3; ++k)
        cov.K(n + 1 + k, n + 1 + k) = -slopeRidge;
}

// S -= C^T K^-1 C, lower triangle, in column stripes that both cores share.
void eliminateValues(Covariance &cov)
{
    cov.lu.compute(cov.K);
    const Eigen::Index columns = cov.C.cols();
    parallelChunks(std::size_t(columns), 96, [&](std::size_t begin, std::size_t end) {
        const Eigen::Index first = Eigen::Index(begin), count = Eigen::Index(end - begin);
        const Eigen::MatrixXd solved = cov.lu.solve(cov.C.middleCols(first, count));
        cov.S.block(first, first, columns - first, count).noalias() -=
            cov.C.rightCols(columns - first).transpose() * solved;
    });
    cov.S.triangularView<Eigen::StrictlyUpper>() = cov.S.transpose();
}

Eigen::VectorXd normalisedPerPoint(const Eigen::VectorXd &g)
{
    const Eigen::Index n = g.size() / 3;
    Eigen::VectorXd result = g;
    for (Eigen::Index i = 0; i < n; ++i) {
        const double length = Vec3(g[i], g[n + i], g[2 * n + i]).norm();
        for (int k = 0; k < 3; ++k)
            result[k * n + i] = length > 1e-300 ? g[k * n + i] / length : (k == 1 ? 1.0 : 0.0);
    }
    return result;
}

// The largest eigenvector of S is the start of lowest relaxed energy.
std::optional<Eigen::VectorXd> eigenStart(const Eigen::MatrixXd &S)
{
    Spectra::DenseSymMatProd<double> product(S);
    Spectra::SymEigsSolver<Spectra::DenseSymMatProd<double>> solver(product, 1, std::min<int>(24, int(S.rows())));
    const Eigen::VectorXd first = Eigen::VectorXd::LinSpaced(S.rows(), 0.5, 1.5);
    solver.init(first.data());
    solver.compute(Spectra::SortRule::LargestAlge, 60, 1e-4);
    if (solver.info() != Spectra::CompInfo::Successful)
        return std::nullopt;
    return normalisedPerPoint(solver.eigenvectors().col(0));
}

} // namespace

bool isFlat(const std::vector<Vec3> &points)
{
    Vec3 mean = Vec3::Zero();
    for (const Vec3 &p : points)
        mean += p / double(points.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3 &p : points)
        spread += (p - mean) * (p - mean).transpose() / double(points.size());
    return std::sqrt(std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues()[0])) < 1e-4;
}

Result<VariationalFit> fitVariational(const std::vector<Vec3> &points, const std::vector<Vec3> &priorNormals,
                                      const VariationalFitOptions &options, const JobControl &control)
{
    const Eigen::Index n = Eigen::Index(points.size());
    if (n < 8)
        return Error{ErrorCode::TooLittleData, attempted, "there are fewer than eight different points",
                     "Draw more strokes, or give a proxy mesh", ""};
    if (!(options.slopeRidge > 0.0) && isFlat(points))
        return Error{ErrorCode::NoSolution, attempted, "all points lie in one plane",
                     "Draw strokes in depth, or give a proxy mesh", ""};

    control.progress(0.0, "Fitting a smooth surface");
    Eigen::VectorXd lambda = Eigen::VectorXd::Constant(n, options.lambda);
    if (!options.pointLambdas.empty())
        lambda = Eigen::Map<const Eigen::VectorXd>(options.pointLambdas.data(), n);
    Covariance cov;
    assemble(points, lambda, options.slopeRidge, cov);
    eliminateValues(cov);
    if (control.isCancelled())
        return cancelledError(attempted);
    control.progress(0.4, "Fitting a smooth surface");

    std::vector<Eigen::VectorXd> starts;
    std::vector<int> startNames;
    if (std::optional<Eigen::VectorXd> start = eigenStart(cov.S)) {
        starts.push_back(std::move(*start));
        startNames.push_back(0);
    }
    if (!priorNormals.empty()) {
        Eigen::VectorXd g(3 * n);
        for (Eigen::Index i = 0; i < n; ++i)
            for (int k = 0; k < 3; ++k)
                g[k * n + i] = priorNormals[std::size_t(i)][k];
        starts.push_back(normalisedPerPoint(g));
        startNames.push_back(1);
    }

    Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(cov.S); // in place: S is not needed again
    if (factor.info() != Eigen::Success || starts.empty())
        return Error{ErrorCode::NoSolution, attempted, "the equations are singular",
                     "Remove strokes drawn twice, or give a proxy mesh", ""};
    if (control.isCancelled())
        return cancelledError(attempted);
    control.progress(0.6, "Fitting a smooth surface");

    const auto applyInverse = [&](const Eigen::VectorXd &g) -> Eigen::VectorXd { return factor.solve(g); };
    SphereDescentOptions descent;
    descent.maxIterations = options.maxIterations;
    descent.tolerance = options.tolerance;
    VariationalFit fit;
    Eigen::VectorXd bestGradients;
    for (std::size_t s = 0; s < starts.size(); ++s) {
        const Result<SphereMinimum> minimum = minimiseOnSpheres(applyInverse, starts[s], descent, control);
        if (!minimum)
            return minimum.error();
        if (s == 0 || minimum->energy < fit.energy) {
            fit.energy = minimum->energy;
            fit.winningStart = startNames[s];
            bestGradients = minimum->g;
        }
    }

    // Coefficients: c = S^-1 g, and values and polynomial from K u = -C c.
    const Eigen::VectorXd c = factor.solve(bestGradients);
    const Eigen::VectorXd u = -cov.lu.solve(cov.C * c);
    fit.field = HermiteField(points, u.head(n), c, u.tail<4>());
    fit.rmsValue = std::sqrt(lambda.cwiseProduct(u.head(n)).squaredNorm() / double(n)); // f(p_i) = -lambda a_i
    for (Eigen::Index i = 0; i < n; ++i)
        fit.normals.push_back({bestGradients[i], bestGradients[n + i], bestGradients[2 * n + i]});
    return fit;
}

} // namespace ductus
