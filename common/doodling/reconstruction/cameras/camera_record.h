// Cameras as a record of the cache, and as a key for what was found with them.
#pragma once

#include "doodling/cache/shot_store.h"
#include "doodling/reconstruction/shot.h"

namespace ductus {

/// Of cameras, knowledge and scale: what depth depends on besides the motion.
std::string cameraKey(const Shot &shot);

Result<void> keepCameras(ShotStore &store, const Shot &shot);
/// False if there are none for \a frameCount frames.
bool takeCameras(ShotStore &store, int frameCount, Shot &shot);

} // namespace ductus
