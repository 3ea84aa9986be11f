#include "doodling/tracking/pixel_path.h"

#include "doodling/tracking/motion_between.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ductus {

namespace {

double placeCost(const Shot &shot, const Proposal &place, const PixelPathOptions &options)
{
    const double look = std::pow(place.difference / options.alikeDifference, 2);
    const double cost = std::min(look, options.mostLookCost) +
                        std::min(options.thingShare * place.farness * place.farness, options.mostThingCost) +
                        (place.isFound ? options.foundCost : 0.0);
    return isInside(shot, place.pixel) ? cost : cost + options.outsideCost;
}

// Where the flow takes the places of a frame until the next one.
std::vector<Vec2> movedPlaces(const Shot &shot, const std::vector<Proposal> &places, int from, int to)
{
    std::vector<Vec2> moved;
    for (const Proposal &place : places)
        moved.push_back(place.pixel + motionBetween(shot, from, to, place.pixel)->motion);
    return moved;
}

struct Layer
{
    std::vector<double> costs;
    std::vector<std::size_t> origins;
    std::vector<double> misses; // of the best step to the place, pixels
};

// The step agrees if the flow from either end says so: where something is covered or uncovered one of them
// shows something else.
Layer reached(const Shot &shot, const std::vector<Proposal> &before, const Layer &layerBefore,
              const std::vector<Proposal> &here, int from, int to, const PixelPathOptions &options)
{
    const std::vector<Vec2> ahead = movedPlaces(shot, before, from, to),
                            back = movedPlaces(shot, here, to, from);
    Layer layer;
    for (std::size_t j = 0; j < here.size(); ++j) {
        double least = std::numeric_limits<double>::infinity(), leastMiss = 0.0;
        std::size_t origin = 0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            const double miss =
                std::min((here[j].pixel - ahead[i]).norm(), (back[j] - before[i].pixel).norm());
            const double cost =
                layerBefore.costs[i] + std::min(std::pow(miss / options.stepPixels, 2), options.mostStepCost);
            if (cost < least) {
                least = cost;
                leastMiss = miss;
                origin = i;
            }
        }
        layer.costs.push_back(least + placeCost(shot, here[j], options));
        layer.origins.push_back(origin);
        layer.misses.push_back(leastMiss);
    }
    return layer;
}

// Hidden stretches: what is seen there is something else, and so is its motion. The point goes evenly from
// where it was seen last to where it is seen again; after the last time it goes with its thing.
void bridgeHidden(const std::vector<ExpectedPlace> &expected, std::vector<PathPoint> &path)
{
    std::size_t seen = 0; // the last frame that was; the keyframe is, whatever it looks like
    for (std::size_t i = 1; i <= path.size(); ++i) {
        if (i < path.size() && !path[i].isVisible)
            continue;
        for (std::size_t k = seen + 1; k < i; ++k) {
            const double share = double(k - seen) / double(i - seen);
            path[k].pixel = i < path.size()
                                ? Vec2((1.0 - share) * path[seen].pixel + share * path[i].pixel)
                                : Vec2(path[seen].pixel + expected[k].pixel - expected[seen].pixel);
        }
        seen = i;
    }
}

} // namespace

std::vector<PathPoint> pixelPath(const Shot &shot, const PixelKeyframe &from,
                                 const std::optional<PixelKeyframe> &to, int end,
                                 const PixelPathOptions &options)
{
    PathProposals proposals = proposePaths(shot, from, to, end, options.proposals);
    std::vector<std::vector<Proposal>> &frames = proposals.frames;
    frames.insert(frames.begin(), std::vector<Proposal>{{from.pixel, 0.0, 0.0, false}});
    const int direction = (to ? to->frame : end) >= from.frame ? 1 : -1;
    std::vector<Layer> layers(frames.size());
    layers[0] = {{0.0}, {0}, {0.0}};
    for (std::size_t i = 1; i < frames.size(); ++i) {
        const int frame = from.frame + direction * int(i);
        layers[i] = reached(shot, frames[i - 1], layers[i - 1], frames[i], frame - direction, frame, options);
    }
    std::vector<PathPoint> path(frames.size());
    const std::vector<double> &last = layers.back().costs;
    std::size_t at = std::size_t(std::min_element(last.begin(), last.end()) - last.begin());
    for (std::size_t i = frames.size(); i-- > 0;) {
        const Proposal &place = frames[i][at];
        path[i].pixel = place.pixel;
        path[i].isVisible = isInside(shot, place.pixel) && place.difference < options.hiddenDifference;
        path[i].turn = proposals.support.turns[i];
        path[i].growth = proposals.support.growths[i];
        at = layers[i].origins[at];
    }
    if (to)
        path.back().isVisible = true;
    path.front().isVisible = true;
    bridgeHidden(proposals.support.places, path);
    return path;
}

} // namespace ductus
