// The lowest part of a symmetric positive semidefinite sparse matrix' spectrum.
#pragma once

#include "base/job_control.h"
#include "base/result.h"

#include <Eigen/SparseCore>

namespace ductus {

struct Eigenpairs
{
    Eigen::VectorXd values;  // ascending
    Eigen::MatrixXd vectors; // one column a value, orthonormal
};

/// The min(\a count, size) lowest eigenpairs of \a matrix (symmetric positive semidefinite, eigenvalues of
/// order 1, both triangles stored): shift-invert block Lanczos with full reorthogonalisation and thick
/// restarts [Grimes, Lewis, Simon 1994], dense for small matrices. Blocks find eigenvalues of multiplicity up
/// to 8. Deterministic: fixed start vectors, fixed order of sums. Fails with Cancelled, or NoSolution when
/// the iteration does not converge.
Result<Eigenpairs> lowestEigenpairs(const Eigen::SparseMatrix<double> &matrix, int count,
                                    const JobControl &control);

} // namespace ductus
