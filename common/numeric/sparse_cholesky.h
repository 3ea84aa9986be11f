// Sparse symmetric positive definite solves: one symbolic analysis, many factorisations, many right-hand
// sides.
//
// A multifrontal factorisation of our own on Eigen's dense kernels, ordered by METIS. Measured (CPU seconds,
// g++ 12 -O2, one thread's worth; ours spreads them over the cores) on L^T L + I of a triangulated torus of
// 20,000 vertices, and on its 60,000-unknown version with three coupled unknowns a vertex:
//                                      20,000: factor   60,000: factor   60,000: one solve
//     Eigen SimplicialLDLT, AMD             1.05              31
//     Eigen SimplicialLDLT, METIS           0.39              18.9             0.09
//     CHOLMOD supernodal, ATLAS             0.18               4.2             0.06
//     this                                  0.10-0.17          2.4             0.05
// (analysis 0.15 and 0.4 s, most of it METIS). CHOLMOD's results would depend on which BLAS the machine has;
// here the order of all sums is fixed, so the same matrix gives the same bits on any number of cores.
#pragma once

#include <Eigen/SparseCore>
#include <memory>

namespace ductus {

class SparseCholesky
{
public:
    SparseCholesky();
    ~SparseCholesky();
    SparseCholesky(SparseCholesky &&) noexcept;
    SparseCholesky &operator=(SparseCholesky &&) noexcept;

    /// Orders for the pattern of the square \a matrix (both triangles stored, or the lower one, which is what
    /// is read). Later calls of factorize() with the same pattern reuse it.
    void analyze(const Eigen::SparseMatrix<double> &matrix);

    /// False if the matrix is not positive definite (or holds a value that is not finite). Analyses first
    /// when that was not done, or for another pattern.
    bool factorize(const Eigen::SparseMatrix<double> &matrix);

    /// Columns of \a rightHandSides are solved for independently; factorize() must have succeeded.
    Eigen::MatrixXd solve(const Eigen::MatrixXd &rightHandSides) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> mImplementation;
};

} // namespace ductus
