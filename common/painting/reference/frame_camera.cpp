#include "painting/reference/frame_camera.h"

#include <cmath>
#include <numbers>

namespace ductus {

FrameCamera FrameCamera::of(const CameraKey &key, double aspect)
{
    FrameCamera camera;
    camera.eye = key.eye;
    camera.rotation = key.rotation;
    camera.up = std::tan(key.verticalViewDegrees * std::numbers::pi / 360);
    camera.down = -camera.up;
    camera.right = camera.up * aspect;
    camera.left = -camera.right;
    return camera;
}

FrameCamera FrameCamera::lookingAt(const Vec3 &eye, const Vec3 &target, double verticalViewDegrees,
                                   double aspect, const Vec3 &up)
{
    const Vec3 back = (eye - target).normalized();
    Vec3 right = up.cross(back);
    right = right.norm() > 1e-9 ? Vec3(right.normalized()) : back.unitOrthogonal();
    Eigen::Matrix3d axes;
    axes << right, back.cross(right), back;
    CameraKey key;
    key.eye = eye;
    key.rotation = Eigen::Quaterniond(axes);
    key.verticalViewDegrees = verticalViewDegrees;
    return of(key, aspect);
}

bool FrameCamera::isValid() const
{
    return eye.allFinite() && rotation.coeffs().allFinite() && std::abs(rotation.norm() - 1) < 1e-6 &&
           std::isfinite(left) && std::isfinite(right) && std::isfinite(down) && std::isfinite(up) &&
           left < right && down < up && nearDepth >= 0 && std::isfinite(nearDepth);
}

} // namespace ductus
