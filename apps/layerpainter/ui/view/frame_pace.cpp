#include "layerpainter/ui/view/frame_pace.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr double rowOfEdits = 400; // milliseconds between two that belong together

} // namespace

void FramePace::move()
{
    if (mIsMoving)
        return;
    mIsMoving = true;
    // Most of a frame's cost on a processor goes with its pixels.
    mDivisor = 1;
    while (mDivisor < coarsest && mSharpMilliseconds > targetMilliseconds * mDivisor * mDivisor)
        ++mDivisor;
}

void FramePace::edit(double now)
{
    if (now - mLastEdit < rowOfEdits)
        move();
    mLastEdit = now;
}

void FramePace::drawn(double milliseconds)
{
    if (!mIsMoving) {
        mSharpMilliseconds = milliseconds;
        return;
    }
    if (milliseconds > 1.3 * targetMilliseconds && mDivisor < coarsest) {
        ++mDivisor;
        // What was believed was too little; otherwise the next movement would begin too fine again.
        mSharpMilliseconds =
            std::max(mSharpMilliseconds, 1.01 * targetMilliseconds * (mDivisor - 1) * (mDivisor - 1));
    }
}

} // namespace ductus
