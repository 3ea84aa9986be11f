// From where a frame is seen.
#pragma once

#include "geometry/triangle_mesh.h"
#include "painting/scene/motion.h"

namespace ductus {

/// A pinhole; the tangents may be uneven, as those of a headset's eyes are.
struct FrameCamera
{
    Vec3 eye = Vec3::Zero();                                      // scene units
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity(); // looks along its -z, y is up
    double left = -1, right = 1, down = -1, up = 1; // tangents of the picture's borders, left < right
    double nearDepth = 0;                           // what is nearer is not seen

    /// Through a place of the picture, x from the left and y from the top, 0..1: as long as depth grows by 1.
    Vec3 ray(double x, double y) const
    {
        return rotation * Vec3(left + x * (right - left), up + y * (down - up), -1);
    }

    /// \a aspect is width / height.
    static FrameCamera of(const CameraKey &key, double aspect);
    static FrameCamera lookingAt(const Vec3 &eye, const Vec3 &target, double verticalViewDegrees,
                                 double aspect, const Vec3 &up = Vec3::UnitY());

    bool isValid() const;
};

} // namespace ductus
