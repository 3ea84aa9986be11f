// The camera of one frame of a shot. Pixels: x right, y down, whole numbers at the corners of the image's
// pixels (the middle of the first one is 0.5, 0.5). Camera axes: x right, y down, z into the picture; depth
// is z.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <optional>

namespace ductus {

using Vec2 = Eigen::Vector2d;

struct ShotCamera
{
    Eigen::Isometry3d worldFromCamera = Eigen::Isometry3d::Identity();
    double focal = 1.0;         // pixels; square ones
    Vec2 centre = Vec2::Zero(); // of projection, pixels

    Vec3 position() const { return worldFromCamera.translation(); }

    /// World direction of a pixel's ray, scaled so that position() + depth * rayOf(pixel) has that depth.
    Vec3 rayOf(const Vec2 &pixel) const;
    Vec3 unprojected(const Vec2 &pixel, double depth) const { return position() + depth * rayOf(pixel); }

    double depthOf(const Vec3 &pointInWorld) const;
    /// Nothing for points behind the camera or in its plane.
    std::optional<Vec2> projected(const Vec3 &pointInWorld) const;
};

} // namespace ductus
