// What both hands do at a moment, whatever they hold.
#pragma once

#include <Eigen/Geometry>

#include <array>

namespace ductus {

enum class Hand { Left, Right };

inline Hand other(Hand hand)
{
    return hand == Hand::Left ? Hand::Right : Hand::Left;
}

/// Turned and moved, metres; what points along its -z.
struct RoomPose
{
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();

    Eigen::Vector3d forward() const { return orientation * -Eigen::Vector3d::UnitZ(); }
};

struct HandInput
{
    bool isTracked = false; // else nothing below counts
    RoomPose grip;          // of the palm
    RoomPose aim;           // of the pointing ray; the tip of the brush is its origin
    double trigger = 0;     // 0..1
    double squeeze = 0;     // 0..1
    Eigen::Vector2d stick = Eigen::Vector2d::Zero(); // -1..1, right and up
    bool primary = false;                            // A or X
    bool secondary = false;                          // B or Y
};

struct HandsInput
{
    std::array<HandInput, 2> hands;
    RoomPose head;
    double seconds = 0; // since the last one

    const HandInput &of(Hand hand) const { return hands[hand == Hand::Left ? 0 : 1]; }
    HandInput &of(Hand hand) { return hands[hand == Hand::Left ? 0 : 1]; }
};

} // namespace ductus
