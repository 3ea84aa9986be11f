// Reads a clip's frames one after the other and notes in a shot how they move, between neighbours and over
// long gaps, and what they look like.
#pragma once

#include "doodling/reconstruction/shot.h"

#include <deque>

namespace ductus {

class MotionReader
{
public:
    MotionReader(int frameCount, const FlowOptions &options) : mFrameCount(frameCount), mOptions(options) {}

    /// The next frame. \a shot gets its features, its small picture and the flows that end at it. At most 17
    /// frames are held, besides the shot.
    void add(const Image &frame, Shot &shot);

private:
    int mFrameCount;
    FlowOptions mOptions;
    int mFrame = 0;
    std::deque<FlowPicture> mBefore; // the last one is the frame before
};

} // namespace ductus
