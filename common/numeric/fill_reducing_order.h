// The order of elimination that keeps a sparse Cholesky factor sparse.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace ductus {

/// Position -> row of \a matrix: the row to eliminate first, second, ... Only the pattern of the lower
/// triangle is read; \a matrix must be square and compressed. Nested dissection (METIS) for large matrices,
/// minimum degree (Eigen's AMD) for small ones. Deterministic.
std::vector<int> fillReducingOrder(const Eigen::SparseMatrix<double> &matrix);

} // namespace ductus
