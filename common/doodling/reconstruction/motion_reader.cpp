#include "doodling/reconstruction/motion_reader.h"

#include "base/parallel.h"

#include <algorithm>
#include <iterator>

namespace ductus {

void MotionReader::add(const Image &frame, Shot &shot)
{
    shot.features.push_back(featuresOf(frame));
    shot.pictures.push_back(smallPictureOf(frame));
    FlowPicture here = flowPictureOf(frame);
    if (mFrame > 0) {
        std::vector<int> gaps = longGapsTo(mFrame, mFrameCount);
        gaps.insert(gaps.begin(), 1);
        std::vector<FlowPair> pairs(gaps.size());
        parallelFor(0, gaps.size(), [&](std::size_t i) {
            FlowOptions options = mOptions;
            // Over long gaps what looks alike has changed by more than the finer size would tell.
            options.isFullSize = options.isFullSize && gaps[i] == 1;
            pairs[i] = denseFlow(mBefore[mBefore.size() - std::size_t(gaps[i])], here, options);
        });
        for (std::size_t i = 1; i < gaps.size(); ++i)
            shot.longFlows[{mFrame - gaps[i], gaps[i]}] = {compacted(pairs[i].forward),
                                                           compacted(pairs[i].backward)};
        shot.forward.push_back(std::move(pairs.front().forward));
        shot.backward.push_back(std::move(pairs.front().backward));
    }
    mBefore.push_back(std::move(here));
    if (int(mBefore.size()) > *std::prev(std::end(longGaps)))
        mBefore.pop_front();
    ++mFrame;
}

} // namespace ductus
