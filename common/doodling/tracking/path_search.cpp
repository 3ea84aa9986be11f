#include "doodling/tracking/path_search.h"

#include "doodling/tracking/motion_between.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ductus {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// How a point is known to be seen at a place: the flow led there without a break from the start, or leads on
// to the end without one; what changes its looks so is the thing itself. Else looks alone tell.
enum Knowledge { FromStart, ByLooks, ToEnd, knowledgeCount };

struct Arrival
{
    double cost = infinite;
    std::size_t frame = 0, place = 0; // come from; a frame further back: hidden in between
    int knowledge = FromStart;
};

using Arrivals = std::array<Arrival, knowledgeCount>;

void improve(Arrival &arrival, double cost, std::size_t frame, std::size_t place, int knowledge)
{
    if (cost < arrival.cost)
        arrival = {cost, frame, place, knowledge};
}

struct MovedPlace
{
    Vec2 pixel = Vec2::Zero();
    double deviation = 0.0; // pixels
};

class PathSearch
{
public:
    PathSearch(const Shot &shot, const PathProposals &proposals, int from, int direction, bool isClosed,
               const PixelPathOptions &options)
        : mShot(shot), mFrames(proposals.frames), mThing(proposals.support.places), mFrom(from),
          mDirection(direction), mIsClosed(isClosed), mOptions(options)
    {
        mArrivals.resize(mFrames.size());
        for (std::size_t i = 0; i < mFrames.size(); ++i)
            mArrivals[i].resize(mFrames[i].size());
        mArrivals[0][0][FromStart].cost = 0.0;
        for (std::size_t i = 1; i < mFrames.size(); ++i) {
            goByFlow(i);
            goHidden(i);
        }
    }

    std::vector<PathPoint> best() const
    {
        std::vector<PathPoint> path(mFrames.size());
        for (PathPoint &point : path)
            point.isVisible = false;
        for (Arrival at = end();;) {
            const Proposal &place = mFrames[at.frame][at.place];
            const bool isLike = at.knowledge != ByLooks || place.difference < mOptions.hiddenDifference;
            path[at.frame] = {place.pixel, isInside(mShot, place.pixel) && isLike, 0.0, 1.0};
            if (at.frame == 0)
                break;
            at = mArrivals[at.frame][at.place][std::size_t(at.knowledge)];
        }
        path.front().isVisible = true;
        if (mIsClosed)
            path.back().isVisible = true;
        return path;
    }

private:
    int frameOf(std::size_t i) const { return mFrom + mDirection * int(i); }

    bool isPossible(int knowledge) const { return knowledge != ToEnd || mIsClosed; }

    double placeCost(const Proposal &place, int knowledge) const
    {
        const double look = std::pow(place.difference / mOptions.alikeDifference, 2);
        const double most = knowledge == ByLooks ? mOptions.mostLookCost : mOptions.mostLedLookCost;
        const double cost = std::min(look, most) +
                            std::min((mIsClosed ? mOptions.closedThingShare : mOptions.thingShare) *
                                         place.farness * place.farness,
                                     mOptions.mostThingCost) +
                            (place.isFound ? mOptions.foundCost : 0.0);
        return isInside(mShot, place.pixel) ? cost : cost + mOptions.outsideCost;
    }

    // Where the flow takes the places of a frame until the next one, and how far it is off as it seems.
    std::vector<MovedPlace> movedPlaces(std::size_t from, std::size_t to) const
    {
        const double sure = mIsClosed ? mOptions.closedStepPixels : mOptions.stepPixels;
        std::vector<MovedPlace> moved;
        for (const Proposal &place : mFrames[from]) {
            const MotionAt motion = *motionBetween(mShot, frameOf(from), frameOf(to), place.pixel);
            moved.push_back({place.pixel + motion.motion, sure + mOptions.disagreeingShare * missOf(motion)});
        }
        return moved;
    }

    bool isUnbrokenStep(const Proposal &before, const Proposal &here, double miss) const
    {
        const double length = (here.pixel - before.pixel).norm();
        return here.difference < mOptions.otherDifference &&
               miss < mOptions.unbrokenPixels + mOptions.unbrokenShare * length;
    }

    // The step agrees if the flow from either end says so: where something is covered or uncovered one of
    // them shows something else. It is unbroken if both do.
    void goByFlow(std::size_t to)
    {
        const std::vector<Proposal> &before = mFrames[to - 1], &here = mFrames[to];
        const std::vector<MovedPlace> ahead = movedPlaces(to - 1, to), back = movedPlaces(to, to - 1);
        for (std::size_t j = 0; j < here.size(); ++j) {
            Arrivals &arrivals = mArrivals[to][j];
            for (std::size_t i = 0; i < before.size(); ++i) {
                const Arrivals &origin = mArrivals[to - 1][i];
                const double missAhead = (here[j].pixel - ahead[i].pixel).norm(),
                             missBack = (back[j].pixel - before[i].pixel).norm();
                const double miss = std::min(missAhead / ahead[i].deviation, missBack / back[j].deviation);
                const double step = std::min(miss * miss, mOptions.mostStepCost);
                const bool isUnbroken = isUnbrokenStep(before[i], here[j], std::max(missAhead, missBack));
                for (int k = 0; k < knowledgeCount; ++k)
                    for (int l = k; l < knowledgeCount; ++l) {
                        const bool staysLed = k == l && k != ByLooks;
                        if (staysLed && !isUnbroken)
                            continue;
                        improve(arrivals[std::size_t(l)], origin[std::size_t(k)].cost + step, to - 1, i, k);
                    }
            }
            for (int l = 0; l < knowledgeCount; ++l)
                arrivals[std::size_t(l)].cost += isPossible(l) ? placeCost(here[j], l) : infinite;
        }
    }

    // Over frames in which something is before it the point goes with its thing, more or less.
    void goHidden(std::size_t to)
    {
        const std::size_t most = std::size_t(mOptions.mostHiddenFrames);
        const std::size_t first = to > most + 1 ? to - most - 1 : 0;
        for (std::size_t from = first; from + 1 < to; ++from) {
            const double gap = double(to - from);
            const Vec2 thing = mThing[to].pixel - mThing[from].pixel;
            const double pause = mOptions.vanishCost + mOptions.hiddenCost * (gap - 1.0);
            for (std::size_t i = 0; i < mFrames[from].size(); ++i) {
                const Arrivals &origin = mArrivals[from][i];
                const int k = origin[FromStart].cost < origin[ByLooks].cost ? FromStart : ByLooks;
                for (std::size_t j = 0; j < mFrames[to].size(); ++j) {
                    const Vec2 miss = mFrames[to][j].pixel - mFrames[from][i].pixel - thing;
                    const double cost =
                        origin[std::size_t(k)].cost + pause +
                        miss.squaredNorm() / (mOptions.hiddenPixels * mOptions.hiddenPixels * gap);
                    for (int l : {int(ByLooks), int(ToEnd)})
                        if (isPossible(l))
                            improve(mArrivals[to][j][std::size_t(l)], cost + placeCost(mFrames[to][j], l),
                                    from, i, k);
                }
            }
        }
    }

    // As an arrival from the last frame in which the point is seen.
    Arrival end() const
    {
        Arrival end;
        const std::size_t last = mFrames.size() - 1;
        for (std::size_t frame = mIsClosed ? last : 0; frame <= last; ++frame) {
            const double pause =
                frame < last ? mOptions.vanishCost + mOptions.hiddenCost * double(last - frame) : 0.0;
            for (std::size_t i = 0; i < mFrames[frame].size(); ++i)
                for (int k = 0; k < knowledgeCount; ++k)
                    improve(end, mArrivals[frame][i][std::size_t(k)].cost + pause, frame, i, k);
        }
        return end;
    }

    const Shot &mShot;
    const std::vector<std::vector<Proposal>> &mFrames;
    const std::vector<ExpectedPlace> &mThing;
    int mFrom, mDirection;
    bool mIsClosed;
    const PixelPathOptions &mOptions;
    std::vector<std::vector<Arrivals>> mArrivals;
};

} // namespace

std::vector<PathPoint> bestPath(const Shot &shot, const PathProposals &proposals, int from, int direction,
                                bool isClosed, const PixelPathOptions &options)
{
    return PathSearch(shot, proposals, from, direction, isClosed, options).best();
}

} // namespace ductus
