// The trajectory in the picture (thesis VI.5.2, Eq. VI.1): through one proposed place a frame, so that steps
// agree with the flow, places look like the keyframes and stay with their thing. A layered graph as in the
// thesis, with a handful of proposed places a frame in place of every tenth of the frame's cells: its
// shortest path is found layer by layer in microseconds, to parts of a pixel instead of to half a cell.
#pragma once

#include "doodling/tracking/path_proposals.h"

namespace ductus {

struct PixelPathOptions
{
    double stepPixels = 1.2;        // a step that misses the flow by so much costs 1,
    double closedStepPixels = 2.5;  // or by this between two keyframes: what the flow drifts is spread there;
    double disagreeingShare = 0.5;  // and by so much more for each pixel the flow misses by there and back;
    double mostStepCost = 40.0;     // and at most so much: a leap where the flow is sure is the last resort
    double alikeDifference = 18.0;  // grey levels: costs 1,
    double mostLookCost = 3.0;      // and at most so much: light changes, things turn
    double thingShare = 0.3;        // one deviation from the expected place costs this,
    double closedThingShare = 0.1;  // or this between two keyframes: they hold the point already;
    double mostThingCost = 1.2;     // and at most so much
    double outsideCost = 1.5;       // of a place out of the picture: it looks like nothing
    double foundCost = 0.5;         // of a place found by its look, to which no way led
    double hiddenDifference = 22.0; // grey levels from which on a place shows something else
    double otherDifference = 35.0;  // and however the flow leads there
    double mostLedLookCost = 1.0; // where the flow leads without a break: the thing turned, the light changed
    double unbrokenPixels = 1.0;  // a step misses the flow there and back by less,
    double unbrokenShare = 0.05;  // and this share of its length
    double vanishCost = 16.0;     // of a hidden stretch,
    double hiddenCost = 4.0;      // and of each frame of it: more than any place costs by its look
    double hiddenPixels = 16.0;   // a point that is hidden strays so far from its thing in one frame
    int mostHiddenFrames = 120;   // then it is seen again; or never
    ProposalOptions proposals;
};

struct PathPoint
{
    Vec2 pixel = Vec2::Zero();
    bool isVisible = true;
    double turn = 0.0, growth = 1.0; // of the thing since the keyframe before, see SupportMotion
};

/// From \a from to \a to, or to frame \a end, in either direction; \a from first.
std::vector<PathPoint> pixelPath(const Shot &shot, const PixelKeyframe &from,
                                 const std::optional<PixelKeyframe> &to, int end,
                                 const PixelPathOptions &options);

} // namespace ductus
