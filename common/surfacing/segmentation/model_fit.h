// Fitting one implicit polynomial to stroke points and proxy normals (thesis Sec. III.5.3, Eq. III.6).
//
// Solved are III.6's own normal equations, one alignment row B_p = n_p^T grad X(p) a point:
//     (M^T M + mu sum_p B_p^T B_p + lambda I) theta = mu sum_p B_p^T.
// The thesis prints M_align as one summed row (III.8) and a right side mu M_align^T (III.7), which is not the
// minimiser of III.6. Monomials are taken about the centroid of the points and each column is centred and divided
// by its standard deviation, so that lambda acts alike everywhere; the constant column is left as it is.
#pragma once

#include "surfacing/segmentation/implicit_polynomial.h"

#include <span>

namespace ductus {

struct ModelFitOptions
{
    double alignment = 0.1;      // mu, Sec. III.5.3
    double regularisation = 1.0; // lambda, Sec. III.5.3
    double boost = 1.0;          // factor on both; 10 for the first models (Sec. III.5.3, Initialization)
};

/// A stroke point and the unit normal of the proxy where it projects.
struct OrientedPoint
{
    Vec3 point;
    Vec3 normal;
};

/// \a points must not be empty. With few points the regularisation decides; a plane through them results.
ImplicitPolynomial fitPolynomial(const std::vector<OrientedPoint> &points, std::span<const int> subset, int degree,
                                 const ModelFitOptions &options);

} // namespace ductus
