// Where a point may be in each frame: what different ways to follow it say, where its thing would have it,
// and what looks like it there.
#pragma once

#include "doodling/tracking/support_motion.h"

#include <optional>

namespace ductus {

struct ProposalOptions
{
    double stepDeviation = 0.3;   // see FollowOptions
    double differenceShare = 0.1; // see FollowOptions; half of the ways do not look at all
    double expectedShare = 0.3;   // see FollowOptions; half of the ways expect nothing
    SupportOptions support;
    double searchRadius = 72.0; // pixels around the expected place for what looks alike
    double searchSpacing = 8.0; // pixels
    int alikePlaces = 3;        // a frame
};

struct Proposal
{
    Vec2 pixel = Vec2::Zero();
    double difference = 0.0; // grey levels to the nearest keyframe's look; 0 without pictures
    double farness = 0.0;    // deviations from the expected place
    bool isFound = false;    // by its look, not by a way to it
};

/// One list a frame from \a from to the end (of the segment to \a to, or \a end), not counting \a from. A
/// keyframe \a to closes the segment: its frame has itself as the only proposal.
struct PathProposals
{
    std::vector<std::vector<Proposal>> frames;
    SupportMotion support; // seen from \a from
};

PathProposals proposePaths(const Shot &shot, const PixelKeyframe &from,
                           const std::optional<PixelKeyframe> &to, int end, const ProposalOptions &options);

} // namespace ductus
