// The first pass over a clip: motion and looks of every frame, and the corners the cameras are solved from.
#pragma once

#include "doodling/cache/shot_store.h"
#include "doodling/reconstruction/cameras/point_tracks.h"
#include "doodling/reconstruction/shot.h"

namespace ductus {

/// Everything is in the store: fills the flows and pictures of \a shot, whose cameras say how many frames
/// there are. False if anything is missing; \a shot is then without.
bool takeMotion(ShotStore &store, int frameCount, Shot &shot);

/// Fills size, flows and pictures of \a shot. What is in \a store is taken from there, what is not is put
/// there; null: all is held in memory.
Result<std::vector<PointTrack>> findMotion(Clip &clip, const ShotOptions &options, ShotStore *store,
                                           Shot &shot, const JobControl &control);

} // namespace ductus
