// A pixel followed from its keyframe through the flow, over near and far gaps at once: every frame is reached
// from those before it that the flow joins it with, on the way that gathers the least variance [Neoral 2024].
#pragma once

#include "base/job_control.h"
#include "doodling/reconstruction/shot.h"

#include <vector>

namespace ductus {

struct PixelKeyframe
{
    int frame = 0;
    Vec2 pixel = Vec2::Zero(); // working pixels
};

/// Where the thing around a point is expected to have taken it, frame by frame from the keyframe on.
struct ExpectedPlace
{
    Vec2 pixel = Vec2::Zero();
    double deviation = 0.0; // pixels
};

struct FollowOptions
{
    std::vector<int> gaps{1};
    double stepDeviation = 0.3;   // pixels: of a step whose flow agrees there and back
    double differenceShare = 0.0; // squared pixels of variance for each squared grey level of difference to
                                  // the keyframe's look
    double expectedShare = 0.3;   // squared pixels at one deviation from where it is expected
};

struct FollowedPixel
{
    Vec2 pixel = Vec2::Zero();
    double variance = 0.0; // squared pixels
};

/// From the keyframe to frame \a end, the keyframe first; in either direction. \a expected is empty, or as
/// long as the result: where the flow is lost the pixel goes where it is expected.
std::vector<FollowedPixel> followPixel(const Shot &shot, const PixelKeyframe &keyframe, int end,
                                       const std::vector<ExpectedPlace> &expected,
                                       const FollowOptions &options);

} // namespace ductus
