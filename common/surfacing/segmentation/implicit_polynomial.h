// A surface model: the zero level set of a polynomial of degree 1 to 4 in x, y, z (thesis Sec. III.5.3).
//
// f(x) = X((x - origin))^T theta, X the vector of monomials. The centring and scaling of the monomials that the fit
// uses (model_fit.h) is folded into theta, so that evaluation is one dot product. Coordinates are the pipeline's
// unit frame (box diagonal 1); the gradient of f points out of the shape.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>

namespace ductus {

inline constexpr int maxPolynomialDegree = 4;
inline constexpr int maxMonomialCount = 35;

/// 4, 10, 20, 35 for degree 1 to 4.
int monomialCount(int degree);

/// Monomials of \a p in order of degree: 1, x, y, z, xx, xy, xz, yy, yz, zz, ...; writes monomialCount(degree) values.
void evaluateMonomials(const Vec3 &p, int degree, double *values);

/// The same with the three partial derivatives of each monomial.
void evaluateMonomials(const Vec3 &p, int degree, double *values, double *dx, double *dy, double *dz);

struct ImplicitPolynomial
{
    int degree = 1;
    Vec3 origin = Vec3::Zero();
    Eigen::VectorXd theta; // monomialCount(degree)

    double value(const Vec3 &p) const;
    double valueAndGradient(const Vec3 &p, Vec3 &gradient) const;

    /// Taubin's first-order distance, signed: f / |grad f| (Eq. III.5); 0 gradient gives a large finite number.
    double signedDistance(const Vec3 &p, Vec3 *unitGradient = nullptr) const;
};

/// The model reflected at the plane normal . x = offset (|normal| = 1), so that g(p) = f(mirror(p)).
ImplicitPolynomial mirrored(const ImplicitPolynomial &model, const Vec3 &normal, double offset);

} // namespace ductus
