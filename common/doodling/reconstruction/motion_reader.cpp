#include "doodling/reconstruction/motion_reader.h"

#include "base/parallel.h"

#include <iterator>

namespace ductus {

FrameMotion MotionReader::add(const Image &frame)
{
    FrameMotion motion;
    motion.width = frame.width;
    motion.height = frame.height;
    std::vector<int> gaps;
    if (mFrame > 0) {
        gaps = longGapsTo(mFrame, mFrameCount);
        gaps.insert(gaps.begin(), 1); // the longest work first
    }
    FlowPicture here = flowPictureOf(frame);
    std::vector<const FlowPicture *> others;
    for (int gap : gaps)
        others.push_back(&before(gap));
    std::vector<FlowPair> pairs(gaps.size());
    while (mFinders.size() < gaps.size())
        mFinders.emplace_back();
    parallelFor(0, gaps.size() + 1, [&](std::size_t i) {
        if (i == gaps.size()) {
            motion.picture = smallPictureOf(frame);
            return;
        }
        FlowOptions options = mOptions;
        // Over long gaps what looks alike has changed by more than the finer size would tell.
        options.isFullSize = options.isFullSize && gaps[i] == 1;
        pairs[i] = mFinders[i].find(*others[i], here, options);
    });
    for (std::size_t i = 0; i < gaps.size(); ++i)
        if (gaps[i] == 1) {
            motion.forward = pairs[i].forward;
            motion.backward = pairs[i].backward;
        } else {
            motion.longFlows[gaps[i]] = {pairs[i].forward, pairs[i].backward};
        }
    keep({{}, std::move(here)});
    return motion;
}

void MotionReader::pass(const Image &frame)
{
    keep({frame, std::nullopt});
}

const FlowPicture &MotionReader::before(int gap)
{
    Before &frame = mBefore[mBefore.size() - std::size_t(gap)];
    if (!frame.picture) {
        frame.picture = flowPictureOf(frame.image);
        frame.image = {};
    }
    return *frame.picture;
}

void MotionReader::keep(Before frame)
{
    mBefore.push_back(std::move(frame));
    if (int(mBefore.size()) > *std::prev(std::end(longGaps)))
        mBefore.pop_front();
    ++mFrame;
}

} // namespace ductus
