// Depth of every frame and what moves by itself, from cameras and flow: measured where the camera moved,
// guessed where it did not.
#pragma once

#include "base/job_control.h"
#include "doodling/cache/shot_store.h"
#include "doodling/reconstruction/shot.h"

namespace ductus {

/// Fills shot.depths. Reads the clip twice more, for what looks alike. What is in \a store is taken from
/// there, what is not is put there; null: all is held in memory.
Result<void> findDepth(Clip &clip, const ShotOptions &options, ShotStore *store, Shot &shot,
                       const JobControl &control);

/// Everything is in the store: fills shot.depths. False if anything is missing.
bool takeDepth(ShotStore &store, Shot &shot);

} // namespace ductus
