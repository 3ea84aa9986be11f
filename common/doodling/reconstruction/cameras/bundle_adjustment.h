// Cameras and points moved together until the points are seen where the tracks are (Ceres, Huber's loss).
#pragma once

#include "base/job_control.h"
#include "doodling/reconstruction/cameras/camera_fit.h"

#include <vector>

namespace ductus {

struct BundleSighting
{
    int camera = 0, point = 0;
    Vec2 pixel = Vec2::Zero();
};

struct Bundle
{
    std::vector<ShotCamera> cameras; // one focal length for all, that of the first one
    std::vector<HomogeneousPoint> points;
    std::vector<BundleSighting> sightings;
};

struct BundleOptions
{
    bool isRotationOnly = false; // the cameras stay where they are
    bool solvesFocal = true;
    double likelyFocal = 0.0;  // pixels; 0: no opinion
    double focalSpread = 0.25; // of its logarithm, how firm that opinion is
    // The opinion counts as much as so many sightings a pixel off.
    double focalTrust = 200.0;
    // Where moving and turning look alike the path shall not tremble: a change of speed counts like so many
    // sightings that miss by what it moves the usual point in the picture. Cameras are in order of time.
    double smoothTrust = 4.0;
    double usualDepth = 0.0; // of the points; 0: no smoothing
    double huberPixels = 0.8;
    int iterations = 30;
};

/// False if nothing could be solved; the bundle is then as it was.
bool adjustBundle(Bundle &bundle, const BundleOptions &options, const JobControl &control);

} // namespace ductus
