// How the thing around a point moves: points near it that look and at first move like it are followed, and
// their motion is told as a shift, a turn and a growth in the picture. It tells where the point is while it
// is hidden or the flow has lost it, and lets a canvas follow turns and size (doodles.md section 1).
#pragma once

#include "doodling/tracking/follow_pixel.h"

namespace ductus {

struct SupportOptions
{
    double spacing = 18.0;       // pixels between support points
    double radius = 110.0;       // pixels around the point
    double nearness = 60.0;      // pixels: width of the weight
    double alikeColour = 20.0;   // grey levels: half weight
    double alikeMotion = 1.5;    // pixels a frame: half weight
    int motionFrames = 16;       // looked at from the keyframe on
    double outlierPixels = 6.0;  // of a support point: it went with something else
    double leastDeviation = 8.0; // pixels of the expected place: limbs move within their thing
    std::vector<int> gaps{1};
    double stepDeviation = 0.3; // see FollowOptions
};

/// From the keyframe on.
struct SupportMotion
{
    std::vector<ExpectedPlace> places;
    std::vector<double> turns;   // radians in the picture, clockwise as seen (y is down)
    std::vector<double> growths; // factors

    /// What offsets from the point have become: turned and grown.
    Eigen::Matrix2d warpAt(std::size_t step) const;
};

/// \a followed is the point itself, from the keyframe to \a end.
SupportMotion supportMotion(const Shot &shot, const PixelKeyframe &keyframe, int end,
                            const std::vector<FollowedPixel> &followed, const SupportOptions &options);

} // namespace ductus
