#include "layerpainter/vr/hands/space_stroke.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr double leastPressure = 0.02;

} // namespace

bool SpaceStroke::add(const RoomPose &aim, double pressure, const Placement &roomFromScene)
{
    const Eigen::Vector3d at = roomFromScene.matrix().inverse() * aim.position;
    PaintedPoint point;
    point.position = at.cast<float>();
    // The flat of a ribbon lies in the hand like a knife's: its face looks up from it.
    point.normal =
        (roomFromScene.rotation.conjugate() * (aim.orientation * Eigen::Vector3d::UnitY())).cast<float>();
    if (roomFromScene.mirrored)
        point.normal.x() = -point.normal.x();
    point.halfWidth = float(mBrush.halfWidth * std::clamp(pressure, leastPressure, 1.0));
    point.colour = mBrush.colour;
    if (!mShape.points.empty()) {
        const double step = (at - mShape.points.back().position.cast<double>()).norm();
        if (step < 0.2 * mBrush.halfWidth)
            return false;
    }
    mShape.points.push_back(point);
    return true;
}

} // namespace ductus
