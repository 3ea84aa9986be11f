// From two cameras to all of a clip: frame by frame from the pair outwards, each camera fitted to the points
// known so far, new points along the way, all adjusted together from time to time.
#pragma once

#include "doodling/reconstruction/cameras/camera_fit.h"
#include "doodling/reconstruction/cameras/first_pair.h"

namespace ductus {

struct CameraPathOptions
{
    double likelyFocalShare = 0.95; // of the longer side: a phone's main lens
    int mostAdjustedFrames = 60;    // more are fitted to the points afterwards; half as many while growing
    int mostAdjustedPoints = 500;
    double mostMiss = 1.5; // pixels at 854 of width: of a point that stands still
    int fewestPoints = 16; // a camera needs
};

struct CameraPath
{
    std::vector<ShotCamera> cameras;                     // one a frame
    std::vector<bool> isKnown;                           // one a frame
    std::vector<std::optional<HomogeneousPoint>> points; // one a track; nothing for what moves by itself
    /// Of all sightings in all tracks, the share that this explains to mostMiss.
    double explainedShare = 0.0;
    /// The same for the frame in which it is least: where the path is lost it falls to nothing.
    double leastFrameShare = 0.0;
    double medianMiss = 0.0; // pixels, of the points

    bool isComplete() const;
};

/// The camera moves and turns.
CameraPath growCameraPath(const std::vector<PointTrack> &tracks, int frameCount, const FirstPair &start,
                          const CameraPathOptions &options, const JobControl &control);

/// The camera turns on the spot: points are directions. \a lens says focal length and centre.
CameraPath growTurningPath(const std::vector<PointTrack> &tracks, int frameCount, const ShotCamera &lens,
                           const CameraPathOptions &options, const JobControl &control);

} // namespace ductus
