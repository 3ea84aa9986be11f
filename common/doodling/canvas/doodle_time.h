// Which frame of a doodle is shown when.
#pragma once

#include "doodling/canvas/doodle.h"

namespace ductus {

/// The index of the frame of \a doodle shown in video frame \a videoFrame; none outside of Once and before
/// HoldLast.
std::optional<int> doodleFrameAt(const Doodle &doodle, int videoFrame);

/// Video frames from the begin of the first frame until it all begins again (PingPong: there and back).
int cycleLength(const Doodle &doodle);

/// The first video frame at or after \a videoFrame in which frame \a index is shown; none if there is none.
std::optional<int> nextShowing(const Doodle &doodle, int index, int videoFrame);

/// A frame seen through the one being drawn.
struct OnionLayer
{
    int index = 0; // of the doodle's frames
    int steps = 0; // -1: the one before, 2: the second one after
    double opacity = 0.0;
};

/// Up to \a before and \a after neighbours of frame \a index, the farthest first, as they are to be painted
/// below it. In a Loop the first follows the last; no frame comes twice, nor the one being drawn.
std::vector<OnionLayer> onionSkin(const Doodle &doodle, int index, int before, int after);

} // namespace ductus
