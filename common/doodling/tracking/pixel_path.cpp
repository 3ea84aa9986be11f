#include "doodling/tracking/pixel_path.h"

#include "doodling/tracking/path_search.h"

namespace ductus {

namespace {

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
    std::vector<PathPoint> path = bestPath(shot, proposals, from.frame, direction, to.has_value(), options);
    for (std::size_t i = 0; i < path.size(); ++i) {
        path[i].turn = proposals.support.turns[i];
        path[i].growth = proposals.support.growths[i];
    }
    bridgeHidden(proposals.support.places, path);
    return path;
}

} // namespace ductus
