// Motion between two frames of a shot, near or far apart, whichever flow knows of it.
#pragma once

#include "doodling/reconstruction/shot.h"

#include <optional>

namespace ductus {

/// What the flow from a frame to another one says of a pixel; nothing where there is no such flow.
std::optional<MotionAt> motionBetween(const Shot &shot, int from, int to, const Vec2 &pixel);

/// Gaps a pixel can be followed over in one step: 1 and those of Shot::longFlows, ascending.
std::vector<int> gapsOf(const Shot &shot);

/// A little outside the picture at most: flow far out is that of the border, and leads nowhere.
Vec2 keptNear(const Shot &shot, const Vec2 &pixel);

bool isInside(const Shot &shot, const Vec2 &pixel);

} // namespace ductus
