// WorldGrab: the hands move, turn and size what they hold: the whole canvas, or what is chosen.
#pragma once

#include "layerpainter/vr/hands/hand_input.h"
#include "painting/scene/placement.h"

#include <optional>

namespace ductus {

/// The placement that takes everything back.
Placement inverseOf(const Placement &placement);

/// Room from hand.
Placement placementOf(const RoomPose &pose);

class WorldGrab
{
public:
    /// The hands that hold on to it now; none: it stays. What is returned is where it stands if it stood at
    /// \a present: one hand carries it along, two also turn it around both and size it by their distance.
    /// Nothing jumps when a hand takes hold or lets go.
    Placement move(const std::optional<RoomPose> &left, const std::optional<RoomPose> &right,
                   const Placement &present);
    bool isHeld() const { return mHeld[0] || mHeld[1]; }
    void release() { mHeld[0] = mHeld[1] = false; }

private:
    Placement frame(const std::optional<RoomPose> &left, const std::optional<RoomPose> &right) const;

    bool mHeld[2] = {false, false};
    Placement mStart;  // of the hands, when they took hold
    Placement mObject; // of what they hold, then
    RoomPose mStartHands[2];
};

} // namespace ductus
