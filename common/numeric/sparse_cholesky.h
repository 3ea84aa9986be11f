// Sparse symmetric positive definite solves: one symbolic analysis, many factorisations, many right-hand sides.
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

    /// Orders for the pattern of \a matrix (both triangles stored, or the lower one). Later calls of factorize()
    /// with the same pattern reuse it.
    void analyze(const Eigen::SparseMatrix<double> &matrix);

    /// False if the matrix is not positive definite. Analyses first when that was not done.
    bool factorize(const Eigen::SparseMatrix<double> &matrix);

    /// Columns of \a rightHandSides are solved for independently; factorize() must have succeeded.
    Eigen::MatrixXd solve(const Eigen::MatrixXd &rightHandSides) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> mImplementation;
};

} // namespace ductus
