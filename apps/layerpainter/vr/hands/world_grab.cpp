#include "layerpainter/vr/hands/world_grab.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr double leastDistance = 0.02; // of two hands, metres: nearer they would turn the world by trembling
constexpr double leastScale = 1e-6, mostScale = 1e6;

} // namespace

Placement inverseOf(const Placement &placement)
{
    return placementOf(placement.matrix().inverse());
}

Placement placementOf(const RoomPose &pose)
{
    Placement placement;
    placement.rotation = pose.orientation;
    placement.translation = pose.position;
    return placement;
}

// A frame that moves as the hands do: for two, from the first's direction to the second, turned as little as
// that needs and then by half of what both turn around that line.
Placement WorldGrab::frame(const std::optional<RoomPose> &left, const std::optional<RoomPose> &right) const
{
    if (!left || !right)
        return placementOf(left ? *left : *right);
    const Eigen::Vector3d before = mStartHands[1].position - mStartHands[0].position;
    const Eigen::Vector3d now = right->position - left->position;
    Placement frame;
    frame.translation = 0.5 * (left->position + right->position);
    frame.scale = std::max(now.norm(), leastDistance) / std::max(before.norm(), leastDistance);
    if (now.norm() < leastDistance || before.norm() < leastDistance)
        return frame;
    const auto swing = Eigen::Quaterniond::FromTwoVectors(before, now);
    const Eigen::Vector3d axis = now.normalized();
    double twist = 0;
    const std::pair<const RoomPose &, const RoomPose &> hands[] = {{*left, mStartHands[0]},
                                                                   {*right, mStartHands[1]}};
    for (const auto &[is, was] : hands) {
        Eigen::Quaterniond turned = is.orientation * (swing * was.orientation).conjugate();
        if (turned.w() < 0)
            turned.coeffs() = -turned.coeffs();
        twist += 0.5 * 2 * std::atan2(turned.vec().dot(axis), turned.w());
    }
    frame.rotation = Eigen::AngleAxisd(twist, axis) * swing;
    return frame;
}

Placement WorldGrab::move(const std::optional<RoomPose> &left, const std::optional<RoomPose> &right,
                          const Placement &present)
{
    const bool held[2] = {left.has_value(), right.has_value()};
    if (!held[0] && !held[1]) {
        release();
        return present;
    }
    if (held[0] != mHeld[0] || held[1] != mHeld[1]) {
        mHeld[0] = held[0];
        mHeld[1] = held[1];
        mStartHands[0] = left.value_or(RoomPose());
        mStartHands[1] = right.value_or(RoomPose());
        mStart = frame(left, right);
        mObject = present;
        return present;
    }
    Placement moved = frame(left, right) * inverseOf(mStart) * mObject;
    moved.rotation.normalize();
    if (moved.scale < leastScale || moved.scale > mostScale)
        return present;
    return moved;
}

} // namespace ductus
