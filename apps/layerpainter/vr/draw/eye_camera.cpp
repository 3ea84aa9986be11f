#include "layerpainter/vr/draw/eye_camera.h"

#include <cmath>

namespace ductus {

namespace {

constexpr double standingEyes = 1.6;                      // metres above the floor
constexpr double smallest = 0.2, largest = 60, usual = 2; // diagonals of what fits a room, metres

} // namespace

RoomPose roomPose(const XrPosef &pose)
{
    const auto &q = pose.orientation;
    return {{pose.position.x, pose.position.y, pose.position.z},
            Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized()};
}

FrameCamera roomCamera(const EyeView &eye)
{
    const RoomPose pose = roomPose(eye.pose);
    FrameCamera camera;
    camera.eye = pose.position;
    camera.rotation = pose.orientation;
    camera.left = std::tan(double(eye.field.angleLeft));
    camera.right = std::tan(double(eye.field.angleRight));
    camera.down = std::tan(double(eye.field.angleDown));
    camera.up = std::tan(double(eye.field.angleUp));
    return camera;
}

FrameCamera sceneCamera(const EyeView &eye, const Placement &roomFromScene)
{
    FrameCamera camera = roomCamera(eye);
    camera.eye = roomFromScene.matrix().inverse() * camera.eye;
    camera.rotation = (roomFromScene.rotation.conjugate() * camera.rotation).normalized();
    return camera;
}

Placement firstPlacement(const CameraKey &camera, double diagonal, double metresPerUnit)
{
    Placement placement;
    placement.scale = metresPerUnit;
    const double metres = diagonal * metresPerUnit;
    if (diagonal > 0 && (metres < smallest || metres > largest))
        placement.scale = usual / diagonal;
    const Eigen::Vector3d way = camera.rotation * -Eigen::Vector3d::UnitZ();
    const double azimuth = std::atan2(-way.x(), -way.z());
    placement.rotation = Eigen::AngleAxisd(-azimuth, Eigen::Vector3d::UnitY());
    placement.translation =
        Eigen::Vector3d(0, standingEyes, 0) - placement.scale * (placement.rotation * camera.eye);
    return placement;
}

} // namespace ductus
