#include "numeric/lowest_eigenvectors.h"

#include "base/parallel.h"
#include "base/random.h"
#include "numeric/sparse_cholesky.h"

#include <Eigen/Dense>
#include <algorithm>

namespace ductus {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr const char *attempted = "Finding the lowest eigenvectors";

constexpr int blockSize = 8;
constexpr int largestDense = 300;
constexpr int mostRestarts = 30;

// Makes the singular Laplacian invertible; well below the eigenvalues of interest (about 1e-4 and up on a
// mesh of 20,000 vertices) and well above what the factorisation's rounding turns into noise.
constexpr double shift = 1e-6;

// Of a residual, relative to the eigenvalue of the inverse.
constexpr double tolerance = 1e-8;

// Rows a task: tall products are summed chunk by chunk, in order. Eigen would cut them by the size of the
// machine's caches.
constexpr std::size_t rowsPerChunk = 256;

// a^T b for tall a and b.
MatrixXd tallProduct(const Eigen::Ref<const MatrixXd> &a, const Eigen::Ref<const MatrixXd> &b)
{
    const std::size_t rows = std::size_t(a.rows());
    std::vector<MatrixXd> partial((rows + rowsPerChunk - 1) / rowsPerChunk);
    parallelChunks(rows, rowsPerChunk, [&](std::size_t begin, std::size_t end) {
        const Index first = Index(begin), count = Index(end - begin);
        partial[begin / rowsPerChunk].noalias() =
            a.middleRows(first, count).transpose() * b.middleRows(first, count);
    });
    MatrixXd sum = MatrixXd::Zero(a.cols(), b.cols());
    for (const MatrixXd &part : partial)
        sum += part;
    return sum;
}

// target -= a s, row by row chunk; at most 256 columns of a a time (see rowsPerChunk).
void subtractCombination(const Eigen::Ref<const MatrixXd> &a, const MatrixXd &s, Eigen::Ref<MatrixXd> target)
{
    parallelChunks(std::size_t(a.rows()), rowsPerChunk, [&](std::size_t begin, std::size_t end) {
        const Index first = Index(begin), count = Index(end - begin);
        for (Index column = 0; column < a.cols(); column += Index(rowsPerChunk)) {
            const Index width = std::min(Index(rowsPerChunk), a.cols() - column);
            target.middleRows(first, count).noalias() -=
                a.block(first, column, count, width) * s.middleRows(column, width);
        }
    });
}

MatrixXd combination(const Eigen::Ref<const MatrixXd> &a, const MatrixXd &s)
{
    MatrixXd result = MatrixXd::Zero(a.rows(), s.cols());
    subtractCombination(a, -s, result);
    return result;
}

// Makes the columns of block orthonormal and orthogonal to basis; what vanishes is replaced by random
// directions. Returns R with (block before) = basis (...) + (block after) R.
MatrixXd orthonormalize(const Eigen::Ref<const MatrixXd> &basis, MatrixXd &block, Random &random)
{
    const auto project = [&](Eigen::Ref<MatrixXd> columns) {
        if (basis.cols() == 0)
            return;
        for (int pass = 0; pass < 2; ++pass)
            subtractCombination(basis, tallProduct(basis, columns), columns);
    };
    MatrixXd r = MatrixXd::Zero(block.cols(), block.cols());
    const VectorXd before = block.colwise().norm().transpose();
    project(block);
    for (Index column = 0; column < block.cols(); ++column) {
        bool replaced = false;
        for (;;) {
            for (int pass = 0; pass < 2; ++pass) {
                for (Index other = 0; other < column; ++other) {
                    const double share = block.col(other).dot(block.col(column));
                    block.col(column) -= share * block.col(other);
                    if (!replaced)
                        r(other, column) += share;
                }
            }
            const double norm = block.col(column).norm();
            if (norm > 1e-12 * (replaced ? 1.0 : before[column]) && norm > 0.0) {
                block.col(column) /= norm;
                if (!replaced)
                    r(column, column) = norm;
                break;
            }
            replaced = true;
            for (Index row = 0; row < block.rows(); ++row)
                block(row, column) = random.normal();
            block.col(column).normalize();
            project(block.col(column));
        }
    }
    return r;
}

Eigenpairs denseEigenpairs(const SparseMatrix &matrix, int count)
{
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver{MatrixXd(matrix)};
    return {solver.eigenvalues().head(count), solver.eigenvectors().leftCols(count)};
}

// Of the inverse's Ritz pairs the largest stand last; ours go from the lowest eigenvalue up.
Eigenpairs fromInverse(const Eigen::Ref<const MatrixXd> &basis,
                       const Eigen::SelfAdjointEigenSolver<MatrixXd> &ritz, int count)
{
    Eigenpairs result;
    result.values = ritz.eigenvalues().tail(count).reverse().cwiseInverse().array() - shift;
    result.vectors = combination(basis, ritz.eigenvectors().rightCols(count).rowwise().reverse());
    return result;
}

} // namespace

Result<Eigenpairs> lowestEigenpairs(const SparseMatrix &matrix, int count, const JobControl &control)
{
    const int size = int(matrix.rows());
    count = std::clamp(count, 0, size);
    const int keep = count + 2 * blockSize;                             // Ritz vectors that survive a restart
    const int mostColumns = std::max(3 * count, count + 8 * blockSize); // of the basis
    if (count == 0)
        return Eigenpairs{VectorXd(0), MatrixXd(size, 0)};
    if (size <= largestDense || size <= 2 * mostColumns)
        return denseEigenpairs(matrix, count);

    SparseMatrix identity(size, size);
    identity.setIdentity();
    SparseCholesky inverse;
    if (!inverse.factorize(matrix + shift * identity))
        return Error{ErrorCode::NoSolution, attempted, "the matrix has negative eigenvalues", "", ""};

    // inverse * basis = basis * projected + next * coupling * (last block's rows), exactly as long as only
    // the last block lacks its image in the basis.
    Random random(20240229);
    MatrixXd basis(size, mostColumns + blockSize);
    MatrixXd projected = MatrixXd::Zero(mostColumns + blockSize, mostColumns + blockSize);
    MatrixXd next(size, blockSize);
    for (Index i = 0; i < next.size(); ++i)
        next(i) = random.normal();
    orthonormalize(basis.leftCols(0), next, random);
    Index columns = 0;
    int restarts = 0;
    for (;;) {
        if (control.isCancelled())
            return cancelledError(attempted);
        basis.middleCols(columns, blockSize) = next;
        columns += blockSize;
        MatrixXd image = inverse.solve(next);
        const MatrixXd shares = tallProduct(basis.leftCols(columns), image);
        projected.block(0, columns - blockSize, columns, blockSize) = shares;
        projected.block(columns - blockSize, 0, blockSize, columns) = shares.transpose();
        next = std::move(image);
        const MatrixXd coupling = orthonormalize(basis.leftCols(columns), next, random);
        // The small problem is worth solving now and then only.
        const bool full = columns + blockSize > mostColumns;
        if (columns < count + blockSize || (!full && (columns / blockSize) % 4 != 0))
            continue;
        const MatrixXd small = projected.topLeftCorner(columns, columns);
        const Eigen::SelfAdjointEigenSolver<MatrixXd> ritz((small + small.transpose()) / 2.0);
        const MatrixXd residuals = coupling * ritz.eigenvectors().bottomRightCorner(blockSize, count);
        if ((residuals.colwise().norm().transpose().array() <=
             tolerance * ritz.eigenvalues().tail(count).array())
                .all())
            return fromInverse(basis.leftCols(columns), ritz, count);
        if (!full)
            continue;
        if (++restarts > mostRestarts)
            return Error{ErrorCode::NoSolution, attempted, "the iteration did not converge", "", ""};
        control.progress(double(restarts) / mostRestarts, attempted);
        basis.leftCols(keep) = combination(basis.leftCols(columns), ritz.eigenvectors().rightCols(keep));
        projected.setZero();
        projected.topLeftCorner(keep, keep) = ritz.eigenvalues().tail(keep).asDiagonal();
        columns = keep;
    }
}

} // namespace ductus
