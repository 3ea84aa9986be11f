#include "painting/scene/placement.h"

#include <Eigen/SVD>
#include <cmath>

namespace ductus {

Eigen::Affine3d Placement::matrix() const
{
    const Eigen::Vector3d scales(mirrored ? -scale : scale, scale, scale);
    return Eigen::Translation3d(translation) * rotation * Eigen::Scaling(scales);
}

bool Placement::isValid() const
{
    return rotation.coeffs().allFinite() && std::abs(rotation.norm() - 1) < 1e-6 && std::isfinite(scale) &&
           scale > 0 && translation.allFinite();
}

bool Placement::operator==(const Placement &other) const
{
    return rotation.coeffs() == other.rotation.coeffs() && scale == other.scale &&
           mirrored == other.mirrored && translation == other.translation;
}

Placement operator*(const Placement &outer, const Placement &inner)
{
    // A mirroring that passes a rotation turns it the other way about y and z.
    const Eigen::Quaterniond &r = inner.rotation;
    const Eigen::Quaterniond passed = outer.mirrored ? Eigen::Quaterniond(r.w(), r.x(), -r.y(), -r.z()) : r;
    Placement product;
    product.rotation = (outer.rotation * passed).normalized();
    product.scale = outer.scale * inner.scale;
    product.mirrored = outer.mirrored != inner.mirrored;
    product.translation = outer.matrix() * inner.translation;
    return product;
}

Placement placementOf(const Eigen::Affine3d &transform)
{
    Placement placement;
    Eigen::Matrix3d linear = transform.linear();
    placement.mirrored = linear.determinant() < 0;
    if (placement.mirrored)
        linear.col(0) *= -1;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(linear, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d rotation = svd.matrixU() * svd.matrixV().transpose();
    if (rotation.determinant() < 0) // only for flat transforms, whose determinant is rounding
        rotation = svd.matrixU() * Eigen::Vector3d(1, 1, -1).asDiagonal() * svd.matrixV().transpose();
    placement.rotation = Eigen::Quaterniond(rotation).normalized();
    placement.scale = svd.singularValues().mean();
    placement.translation = transform.translation();
    return placement;
}

} // namespace ductus
