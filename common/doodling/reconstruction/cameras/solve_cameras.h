// How the camera moved, on the highest rung that the tracks carry: moved, turned on the spot, stood still.
#pragma once

#include "doodling/reconstruction/cameras/camera_path.h"
#include "doodling/reconstruction/shot.h"

namespace ductus {

struct CameraSolution
{
    CameraKnowledge knowledge = CameraKnowledge::Tripod;
    std::vector<ShotCamera> cameras; // one a frame
    /// Points that stand still, world, with the tracks they were made from; only for solved cameras.
    std::vector<std::optional<HomogeneousPoint>> points;
    double medianMiss = 0.0;     // pixels, of what stands still
    double explainedShare = 0.0; // of all sightings, how many the cameras explain
    double parallax = 0.0;       // pixels: what the best turning leaves of what stands still
    double stillShare = 0.0;     // of the tracks, how many hardly move in the picture
};

/// Never fails: with no tracks at all the camera is said to stand still. Cancelling gives that, too.
CameraSolution solveCameras(const std::vector<PointTrack> &tracks, int frameCount, int width, int height,
                            const CameraPathOptions &options, const JobControl &control);

} // namespace ductus
