#include "doodling/tracking/path_proposals.h"

#include "base/parallel.h"
#include "doodling/tracking/motion_between.h"
#include "doodling/tracking/thing_patch.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double sameDistance = 1.0;   // pixels: proposals that are one
constexpr double otherDistance = 10.0; // pixels: places found by their look lie so far apart
constexpr double driftAFrame = 0.1;    // pixels: expected places are less sure with time
constexpr double farnessCost = 0.36;   // grey levels for one squared deviation, in the search by look

using Ways = std::vector<std::vector<FollowedPixel>>;

// Six ways to follow a keyframe: looking at the keyframe's look or not, expecting the thing's motion or not,
// over all gaps; and over short gaps only.
Ways waysFrom(const Shot &shot, const PixelKeyframe &keyframe, int end, const SupportMotion &support,
              const ProposalOptions &options, const std::vector<int> &gaps)
{
    std::vector<FollowOptions> kinds;
    std::vector<bool> expects;
    for (double differenceShare : {0.0, options.differenceShare})
        for (bool isExpecting : {false, true}) {
            kinds.push_back({gaps, options.stepDeviation, differenceShare, options.expectedShare});
            expects.push_back(isExpecting);
        }
    kinds.push_back({{1}, options.stepDeviation, 0.0, 0.0});
    kinds.push_back({{1, 2, 4}, options.stepDeviation, 0.0, 0.0});
    expects.resize(kinds.size(), false);
    Ways ways(kinds.size());
    parallelFor(0, kinds.size(), [&](std::size_t i) {
        ways[i] = followPixel(shot, keyframe, end, expects[i] ? support.places : std::vector<ExpectedPlace>{},
                              kinds[i]);
    });
    return ways;
}

// One keyframe's side of a segment, the keyframe's frame first.
struct Side
{
    PixelKeyframe keyframe;
    SupportMotion support;
    Ways ways;
    Patch patch;
};

Side sideOf(const Shot &shot, const PixelKeyframe &keyframe, int end, const ProposalOptions &options,
            const std::vector<int> &gaps)
{
    Side side{keyframe, {}, {}, {}};
    const std::vector<FollowedPixel> followed =
        followPixel(shot, keyframe, end, {}, {gaps, options.stepDeviation, 0.0, 0.0});
    SupportOptions support = options.support;
    support.gaps = gaps;
    support.stepDeviation = options.stepDeviation;
    side.support = supportMotion(shot, keyframe, end, followed, support);
    side.ways = waysFrom(shot, keyframe, end, side.support, options, gaps);
    if (!shot.pictures.empty())
        side.patch = thingPatchAt(shot, keyframe);
    return side;
}

class Proposer
{
public:
    Proposer(const Shot &shot, const Side &first, const Side *last, int direction,
             const ProposalOptions &options)
        : mShot(shot), mFirst(first), mLast(last), mOptions(options), mCount(first.ways.front().size() - 1),
          mDirection(direction)
    {
    }

    std::vector<Proposal> at(std::size_t step) const
    {
        std::vector<Proposal> proposals;
        const ExpectedPlace expected = expectedAt(step);
        const int frame = mFirst.keyframe.frame + mDirection * int(step);
        const auto add = [&](const Vec2 &pixel, bool isFound) {
            for (const Proposal &other : proposals)
                if ((other.pixel - pixel).norm() < sameDistance)
                    return;
            proposals.push_back({pixel, differenceOf(frame, pixel),
                                 (pixel - expected.pixel).norm() / expected.deviation, isFound});
        };
        for (const std::vector<FollowedPixel> &way : mFirst.ways)
            add(way[step].pixel, false);
        if (mLast)
            for (const std::vector<FollowedPixel> &way : mLast->ways)
                add(way[mCount - step].pixel, false);
        if (mLast)
            for (std::size_t i = 0; i < mFirst.ways.size(); ++i)
                addBridges(mFirst.ways[i], mLast->ways[i], step, add);
        add(expected.pixel, false);
        if (!mShot.pictures.empty())
            for (const Vec2 &pixel : alikePlaces(frame, expected))
                add(pixel, true);
        return proposals;
    }

private:
    // From the keyframe's side, or from both: each misses the other keyframe by a known amount, which is
    // taken off in proportion to time.
    ExpectedPlace expectedAt(std::size_t step) const
    {
        const ExpectedPlace &ahead = mFirst.support.places[step];
        const double aheadDeviation = ahead.deviation + driftAFrame * double(step);
        if (!mLast)
            return {ahead.pixel, aheadDeviation};
        const double share = double(step) / double(mCount);
        const ExpectedPlace &back = mLast->support.places[mCount - step];
        const double backDeviation = back.deviation + driftAFrame * double(mCount - step);
        const Vec2 a = ahead.pixel + share * (mLast->keyframe.pixel - mFirst.support.places[mCount].pixel);
        const Vec2 b =
            back.pixel + (1.0 - share) * (mFirst.keyframe.pixel - mLast->support.places[mCount].pixel);
        return {(1.0 - share) * a + share * b, (1.0 - share) * aheadDeviation + share * backDeviation};
    }

    // A way misses the other keyframe by what it drifted, most of it where it was least sure: with that taken
    // off it meets both. So do the two ways together, the surer one counting more.
    template <typename Add>
    void addBridges(const std::vector<FollowedPixel> &ahead, const std::vector<FollowedPixel> &back,
                    std::size_t step, const Add &add) const
    {
        const Vec2 a = bridged(ahead, mLast->keyframe.pixel, step),
                   b = bridged(back, mFirst.keyframe.pixel, mCount - step);
        const double share = shareOf(ahead[step].variance, back[mCount - step].variance);
        add(a, false);
        add(b, false);
        add((1.0 - share) * a + share * b, false);
    }

    static double shareOf(double variance, double other)
    {
        return variance + other > 0.0 ? variance / (variance + other) : 0.5;
    }

    static Vec2 bridged(const std::vector<FollowedPixel> &way, const Vec2 &end, std::size_t step)
    {
        const double whole = way.back().variance;
        const double share = whole > 0.0 ? std::min(1.0, way[step].variance / whole) : 0.0;
        return way[step].pixel + share * (end - way.back().pixel);
    }

    double differenceOf(int frame, const Vec2 &pixel) const
    {
        if (mShot.pictures.empty())
            return 0.0;
        const SmallPicture &picture = mShot.pictures[std::size_t(frame)];
        const std::size_t step = std::size_t(std::abs(frame - mFirst.keyframe.frame));
        const double first = differenceAt(picture, pixel, mFirst.patch, mFirst.support.warpAt(step));
        return mLast ? std::min(first, differenceAt(picture, pixel, mLast->patch,
                                                    mLast->support.warpAt(mCount - step)))
                     : first;
    }

    // The most alike places near the expected one, each improved by small steps.
    std::vector<Vec2> alikePlaces(int frame, const ExpectedPlace &expected) const
    {
        std::vector<std::pair<double, Vec2>> all;
        const int reach = int(mOptions.searchRadius / mOptions.searchSpacing);
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const Vec2 offset = mOptions.searchSpacing * Vec2(x, y), pixel = expected.pixel + offset;
                if (offset.norm() > mOptions.searchRadius || !isInside(mShot, pixel))
                    continue;
                const double farness = offset.norm() / expected.deviation;
                all.emplace_back(differenceOf(frame, pixel) + farnessCost * farness * farness, pixel);
            }
        std::stable_sort(all.begin(), all.end(),
                         [](const auto &a, const auto &b) { return a.first < b.first; });
        std::vector<Vec2> starts, places;
        for (const auto &[cost, pixel] : all) {
            if (int(starts.size()) >= mOptions.alikePlaces)
                break;
            const Vec2 &here = pixel;
            if (std::any_of(starts.begin(), starts.end(),
                            [&](const Vec2 &other) { return (other - here).norm() < otherDistance; }))
                continue;
            starts.push_back(pixel);
            places.push_back(improved(frame, pixel));
        }
        return places;
    }

    Vec2 improved(int frame, Vec2 pixel) const
    {
        double least = differenceOf(frame, pixel);
        for (double step : {4.0, 2.0, 1.0}) {
            const Vec2 middle = pixel;
            for (const Vec2 &offset : {Vec2(-1, 0), Vec2(1, 0), Vec2(0, -1), Vec2(0, 1), Vec2(-1, -1),
                                       Vec2(1, 1), Vec2(-1, 1), Vec2(1, -1)}) {
                const Vec2 there = middle + step * offset;
                const double difference = differenceOf(frame, there);
                if (difference < least) {
                    least = difference;
                    pixel = there;
                }
            }
        }
        return pixel;
    }

    const Shot &mShot;
    const Side &mFirst;
    const Side *mLast;
    const ProposalOptions &mOptions;
    std::size_t mCount;
    int mDirection;
};

} // namespace

PathProposals proposePaths(const Shot &shot, const PixelKeyframe &from,
                           const std::optional<PixelKeyframe> &to, int end, const ProposalOptions &options)
{
    const std::vector<int> gaps = gapsOf(shot);
    const Side first = sideOf(shot, from, to ? to->frame : end, options, gaps);
    std::optional<Side> last;
    if (to)
        last = sideOf(shot, *to, from.frame, options, gaps);
    const int direction = (to ? to->frame : end) >= from.frame ? 1 : -1;
    const Proposer proposer(shot, first, last ? &*last : nullptr, direction, options);
    PathProposals proposals;
    proposals.support = first.support;
    proposals.frames.resize(first.support.places.size() - 1);
    parallelFor(
        0, proposals.frames.size(),
        [&](std::size_t i) {
            const bool isKeyframe = to && i + 1 == proposals.frames.size();
            proposals.frames[i] =
                isKeyframe ? std::vector<Proposal>{{to->pixel, 0.0, 0.0, false}} : proposer.at(i + 1);
        },
        4);
    return proposals;
}

} // namespace ductus
