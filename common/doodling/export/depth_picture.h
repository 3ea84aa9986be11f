// A frame's depth as a picture.
#pragma once

#include "doodling/reconstruction/shot.h"

namespace ductus {

/// The disparities (1 / depth) that are black and white in all pictures of a shot, so that nothing flickers:
/// the least and greatest of all frames but for one hundredth at each end.
struct DisparityRange
{
    double dark = 0.0, light = 1.0;
};
DisparityRange disparityRange(const Shot &shot);

/// Grey by disparity: near is light. \a width by \a height pixels, which may be more than the shot's.
Image depthPicture(const Shot &shot, int frame, const DisparityRange &range, int width, int height);

} // namespace ductus
