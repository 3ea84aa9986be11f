// Cameras from elsewhere made those of a shot: in working pixels, with the scene's usual depth measured from
// the corners. Their units stay.
#pragma once

#include "doodling/reconstruction/cameras/point_tracks.h"
#include "doodling/reconstruction/shot.h"

namespace ductus {

/// \a cameras: one a frame, pixels of the clip. Fills cameras, knowledge, sceneDepth and nearestDisparity.
void placeGivenCameras(const std::vector<ShotCamera> &cameras, const std::vector<PointTrack> &tracks,
                       Shot &shot);

} // namespace ductus
