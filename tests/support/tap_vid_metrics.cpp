#include "support/tap_vid_metrics.h"

namespace ductus {

namespace {

double share(int part, int whole)
{
    return whole > 0 ? double(part) / whole : 0.0;
}

} // namespace

void TapVidScore::add(const std::vector<TapPoint> &truth, const std::vector<TapPoint> &predicted,
                      int queryFrame, TapQueries queries)
{
    for (int t = 0; t < int(truth.size()); ++t) {
        if (t == queryFrame || (queries == TapQueries::First && t < queryFrame))
            continue;
        const TapPoint &is = truth[std::size_t(t)], &said = predicted[std::size_t(t)];
        ++mFrames;
        mRightOcclusions += is.isVisible == said.isVisible;
        mVisible += is.isVisible;
        const double squared = (is.pixel - said.pixel).squaredNorm();
        for (std::size_t i = 0; i < thresholds.size(); ++i) {
            const bool isWithin = squared < thresholds[i] * thresholds[i];
            mWithin[i] += isWithin && is.isVisible;
            mTruePositives[i] += isWithin && is.isVisible && said.isVisible;
            mFalsePositives[i] += said.isVisible && !(is.isVisible && isWithin);
        }
    }
}

double TapVidScore::averageJaccard() const
{
    double sum = 0.0;
    for (std::size_t i = 0; i < thresholds.size(); ++i)
        sum += share(mTruePositives[i], mVisible + mFalsePositives[i]);
    return sum / double(thresholds.size());
}

double TapVidScore::delta(std::size_t threshold) const
{
    return share(mWithin[threshold], mVisible);
}

double TapVidScore::deltaAverage() const
{
    double sum = 0.0;
    for (std::size_t i = 0; i < thresholds.size(); ++i)
        sum += delta(i);
    return sum / double(thresholds.size());
}

double TapVidScore::occlusionAccuracy() const
{
    return share(mRightOcclusions, mFrames);
}

} // namespace ductus
