// How well points are tracked, as TAP-Vid counts it [Doersch 2022; google-deepmind/tapnet,
// compute_tapvid_metrics]: in pictures scaled to 256 x 256, at 1, 2, 4, 8 and 16 pixels.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace ductus {

struct TapPoint
{
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); // 256 x 256
    bool isVisible = true;
};

enum class TapQueries {
    First,  // one query, the first frame with the point visible; the frames after it count
    Strided // all frames but the query's count
};

/// Sums over tracks; the shares are taken at the end.
class TapVidScore
{
public:
    static constexpr std::array<double, 5> thresholds{1.0, 2.0, 4.0, 8.0, 16.0};

    /// One track and what was predicted for it from a query in \a queryFrame: a point a frame, as many of
    /// each.
    void add(const std::vector<TapPoint> &truth, const std::vector<TapPoint> &predicted, int queryFrame,
             TapQueries queries);

    /// 0..1; 0 where nothing was counted.
    double averageJaccard() const;
    double deltaAverage() const;
    double delta(std::size_t threshold) const;
    double occlusionAccuracy() const;

private:
    int mFrames = 0, mRightOcclusions = 0, mVisible = 0;
    std::array<int, 5> mWithin{}, mTruePositives{}, mFalsePositives{};
};

} // namespace ductus
