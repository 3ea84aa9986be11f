// A scalar field interpolating values and gradients: Hermite radial basis functions with the triharmonic kernel
// r^3 and a linear polynomial (surfacing-research.md section 3; VIPSS [Huang, Carr, Ju 2019]).
//
//     f(x) = sum_i a_i r_i^3 - 3 sum_i r_i (c_i . d_i) + b0 + b . x,   d_i = x - p_i, r_i = |d_i|
//
// Here grad f is the outward normal (the published program has it inward): f < 0 inside.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>

namespace ductus {

class HermiteField
{
public:
    HermiteField() = default;
    /// \a a: n weights; \a c: 3n, all x then all y then all z; \a b: constant and three slopes.
    HermiteField(const std::vector<Vec3> &centres, const Eigen::VectorXd &a, const Eigen::VectorXd &c,
                 const Eigen::Vector4d &b);

    double value(const Vec3 &x) const;
    double valueAndGradient(const Vec3 &x, Vec3 &gradient) const;

    /// The same surface with its sides exchanged.
    HermiteField negated() const;

private:
    Eigen::ArrayXd mX, mY, mZ, mA, mCx, mCy, mCz;
    Eigen::Vector4d mB = Eigen::Vector4d::Zero();
};

} // namespace ductus
