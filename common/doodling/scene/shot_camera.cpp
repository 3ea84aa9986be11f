#include "doodling/scene/shot_camera.h"

namespace ductus {

Vec3 ShotCamera::rayOf(const Vec2 &pixel) const
{
    const Vec2 onPlane = (pixel - centre) / focal;
    return worldFromCamera.linear() * Vec3(onPlane.x(), onPlane.y(), 1.0);
}

double ShotCamera::depthOf(const Vec3 &pointInWorld) const
{
    return worldFromCamera.linear().col(2).dot(pointInWorld - position());
}

std::optional<Vec2> ShotCamera::projected(const Vec3 &pointInWorld) const
{
    const Vec3 inCamera = worldFromCamera.linear().transpose() * (pointInWorld - position());
    if (inCamera.z() <= 0.0)
        return std::nullopt;
    return Vec2(centre + focal * inCamera.head<2>() / inCamera.z());
}

} // namespace ductus
