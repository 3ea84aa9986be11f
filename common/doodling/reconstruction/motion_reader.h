// Takes a clip's frames one after the other and finds how each moved from those before, neighbours and over
// long gaps, and what it looks like.
#pragma once

#include "doodling/reconstruction/frame_motion.h"

#include <deque>
#include <optional>

namespace ductus {

class MotionReader
{
public:
    MotionReader(int frameCount, const FlowOptions &options) : mFrameCount(frameCount), mOptions(options) {}

    /// The next frame. At most 17 frames are held.
    FrameMotion add(const Image &frame);
    /// The next frame, of which all is known already; later ones are compared with it.
    void pass(const Image &frame);

private:
    struct Before
    {
        Image image;                        // until it is needed
        std::optional<FlowPicture> picture; // from then on
    };
    const FlowPicture &before(int gap);
    void keep(Before frame);

    int mFrameCount;
    FlowOptions mOptions;
    int mFrame = 0;
    std::vector<FlowFinder> mFinders; // one a gap
    std::deque<Before> mBefore;       // the last one is the frame before
};

} // namespace ductus
