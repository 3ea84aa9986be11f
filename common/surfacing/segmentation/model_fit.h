// Fitting one implicit polynomial to stroke points and proxy normals (thesis Sec. III.5.3, Eq. III.6).
//
// Solved are III.6's own normal equations, one alignment row B_p = n_p^T grad X(p) a direction:
//     (M^T M + mu sum_p B_p^T B_p + lambda I) theta = mu sum_p B_p^T.
// The thesis prints M_align as one summed row (III.8) and a right side mu M_align^T (III.7), which is not the
// minimiser of III.6, but explains why mu = 0.1 worked there: one summed row fixes a scale and a side, and leaves the
// shape to the points. With one row a direction the same mu lets normals, right to half a radian, overrule points,
// right to a third of a percent of the diagonal: planes through the four edges of a box's side tilted and the best
// degree for it became 4. So mu is the ratio of the two variances here, and counts as if there were one direction a
// point.
//
// Directions are the proxy's normals at vertices without strokes nearby (P'_alpha of Sec. III.5.3): at strokes the
// smooth proxy rounds the very creases we look for. Monomials are taken about the centroid of the points and each column is centred and divided
// by its standard deviation, so that lambda acts alike everywhere; the constant column is left as it is.
#pragma once

#include "surfacing/segmentation/implicit_polynomial.h"

#include <span>

namespace ductus {

struct ModelFitOptions
{
    double alignment = 1e-4;     // mu: (0.003 / 0.3)^2, noise of points against that of the proxy's normals
    double regularisation = 1.0; // lambda, Sec. III.5.3
    double boost = 1.0;          // factor on both; 10 for the first models (Sec. III.5.3, Initialization)
};

/// A stroke point and the unit normal of the proxy where it projects, or a proxy vertex and its normal.
struct OrientedPoint
{
    Vec3 point;
    Vec3 normal;
};

/// Through the \a subset of \a points, which must not be empty, with gradients like the normals of the
/// \a directionSubset of \a directions; if that is empty, like those of the points. With few points the
/// regularisation decides; a plane through them results.
ImplicitPolynomial fitPolynomial(const std::vector<OrientedPoint> &points, std::span<const int> subset,
                                 const std::vector<OrientedPoint> &directions, std::span<const int> directionSubset,
                                 int degree, const ModelFitOptions &options);

/// With the normals of the points themselves.
ImplicitPolynomial fitPolynomial(const std::vector<OrientedPoint> &points, std::span<const int> subset, int degree,
                                 const ModelFitOptions &options);

} // namespace ductus
