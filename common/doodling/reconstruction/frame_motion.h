// What is found when a frame is added to those before: how it looks, and how it moved from them.
#pragma once

#include "doodling/reconstruction/long_flow.h"
#include "doodling/reconstruction/small_picture.h"

namespace ductus {

struct FrameMotion
{
    int width = 0, height = 0; // of the working copy
    SmallPicture picture;
    CompactFlow forward, backward;            // from the frame before and to it; empty for the first frame
    std::map<int, CompactFlowPair> longFlows; // by gap: from the frame so many before, and to it
};

} // namespace ductus
