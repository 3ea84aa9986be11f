// Placement: where something stands: turned, scaled evenly, moved, possibly mirrored.
#pragma once

#include <Eigen/Geometry>

namespace ductus {

/// v' = rotation * scale * mirror(x) * v + translation. Any flip of Quill is a mirrored x and a half turn.
struct Placement
{
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity(); // of length 1
    double scale = 1;                                             // > 0
    bool mirrored = false; // x changes its sign first; reverses the winding of meshes
    Eigen::Vector3d translation = Eigen::Vector3d::Zero(); // scene units

    Eigen::Affine3d matrix() const;
    bool isValid() const;
    bool operator==(const Placement &other) const;
};

/// What stands at \a inner inside something that stands at \a outer.
Placement operator*(const Placement &outer, const Placement &inner);

/// The placement whose matrix is nearest to \a transform among those with the same point of origin; exact for
/// products of turns, moves, even scales and mirrorings.
Placement placementOf(const Eigen::Affine3d &transform);

} // namespace ductus
