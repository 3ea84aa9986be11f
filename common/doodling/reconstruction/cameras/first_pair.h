// Two frames to begin with: far enough apart to show depth, near enough to see the same, and where each
// camera was. Essential matrix by the five-point method in RANSAC [Nister 2004, OpenCV].
#pragma once

#include "base/job_control.h"
#include "doodling/reconstruction/cameras/point_tracks.h"

namespace ductus {

struct FirstPair
{
    int first = 0, second = 0;
    ShotCamera firstCamera, secondCamera; // a step of length 1 apart
    double parallax = 0.0;                // pixels: median of what turning alone leaves
    double score = 0.0;
};

/// Best first, from different parts of the clip; none when no two frames show parallax. \a lens says focal
/// length and centre.
std::vector<FirstPair> firstPairs(const std::vector<PointTrack> &tracks, int frameCount,
                                  const ShotCamera &lens, const JobControl &control);

} // namespace ductus
