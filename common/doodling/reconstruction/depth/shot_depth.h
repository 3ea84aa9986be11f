// Depth of every frame and what moves by itself, from cameras and flow: measured where the camera moved,
// guessed where it did not.
#pragma once

#include "base/job_control.h"
#include "doodling/reconstruction/cameras/camera_fit.h"
#include "doodling/reconstruction/shot.h"

namespace ductus {

/// Fills shot.depths and scales the scene so that its usual depth is shot.sceneDepth. \a points are those
/// that stand still, world, as the cameras were solved with them. Reads the clip once more, for what looks
/// alike.
Result<void> findDepth(Clip &clip, const std::vector<std::optional<HomogeneousPoint>> &points, int mostLines,
                       Shot &shot, const JobControl &control);

} // namespace ductus
