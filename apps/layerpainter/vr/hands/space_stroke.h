// SpaceStroke: a stroke out of what the hand does in the air.
#pragma once

#include "layerpainter/vr/hands/hand_input.h"
#include "painting/action/action.h"

namespace ductus {

class SpaceStroke
{
public:
    struct Brush
    {
        double halfWidth = 0.1; // scene units, at full pressure
        Eigen::Vector3f colour = Eigen::Vector3f::Zero();
        StrokeSection section = StrokeSection::Round;
    };

    explicit SpaceStroke(const Brush &brush) : mBrush(brush) { mShape.section = brush.section; }

    /// The tip is at \a aim in a room where the scene stands at \a roomFromScene; pressure 0..1 is width.
    /// Points that are nearer to the last than a fifth of the brush are left out. True if one was added.
    bool add(const RoomPose &aim, double pressure, const Placement &roomFromScene);

    const StrokeShape &shape() const { return mShape; }

private:
    Brush mBrush;
    StrokeShape mShape;
};

} // namespace ductus
