// How large a scene is that was solved from pictures: they do not tell, so its usual depth is made
// sceneDepth.
#pragma once

#include "doodling/reconstruction/cameras/camera_fit.h"
#include "doodling/reconstruction/shot.h"

namespace ductus {

/// Moves the cameras of \a shot so that its usual depth is shot.sceneDepth, and sets its nearestDisparity.
/// \a points are those that stand still, world, as the cameras were solved with them. Cameras that did not
/// move stay as they are.
void scaleScene(const std::vector<std::optional<HomogeneousPoint>> &points, Shot &shot);

/// The other way round, for cameras whose unit is to stay: sets sceneDepth to the usual depth of the points.
void measureScene(const std::vector<std::optional<HomogeneousPoint>> &points, Shot &shot);

} // namespace ductus
