// VIPSS: the smoothest field that vanishes at points without normals [Huang, Carr, Ju 2019], written anew from the
// formulas in surfacing-research.md section 3.
//
// Unknown are unit gradients g at the n points. With the values' noise folded into the kernel matrix as a nugget
// lambda (equal to minimising sum s_i^2 + lambda * Duchon energy over the values s_i), eliminating values and
// polynomial leaves a 3n x 3n covariance S of the gradients, and the energy of the best field with gradients g is
//     E(g) = g^T S^-1 g.
// This needs one Cholesky factor of S (9 n^3 flops) where the published program inverts a (4n+4)^2 matrix and takes
// five full eigendecompositions; the start that it looks for among the lowest eigenvectors of S^-1 is the highest
// eigenvector of S, a few products by Lanczos. Polished by L-BFGS on the product of spheres.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "surfacing/proxy/hermite_field.h"

namespace ductus {

struct VariationalFitOptions
{
    double lambda = 0.0;       // nugget, in (unit frame)^3; 0 interpolates
    std::vector<double> pointLambdas; // instead, one a point; empty: lambda for all
    double slopeRidge = 0.0;   // energy of a unit slope of the polynomial; > 0 admits points in one plane
    int maxIterations = 120;   // of L-BFGS a start
    double tolerance = 1e-6;   // relative decrease that ends it
};

struct VariationalFit
{
    HermiteField field;
    std::vector<Vec3> normals; // unit gradients at the points
    double energy = 0.0;
    double rmsValue = 0.0; // root mean square of the field at the points: about the distance it leaves them
    int winningStart = 0;  // 0: eigenvector, 1: prior
};

/// True if all points lie in one plane, to within a ten-thousandth of the unit frame: no field can tell its sides.
bool isFlat(const std::vector<Vec3> &points);

/// \a points: distinct, not all in one plane (else NoSolution). \a priorNormals: rough outward directions, one a
/// point, or empty. Memory about 120 n^2 bytes.
Result<VariationalFit> fitVariational(const std::vector<Vec3> &points, const std::vector<Vec3> &priorNormals,
                                      const VariationalFitOptions &options, const JobControl &control);

} // namespace ductus
