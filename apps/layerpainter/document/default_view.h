// From where a painting is seen when nobody has chosen.
#pragma once

#include "geometry/triangle_mesh.h"
#include "painting/scene/painting.h"

namespace ductus {

/// A box around the strokes and meshes of all substrates, at the beginning of their motion; empty without
/// any.
Box3 paintingBox(const Painting &painting);

/// The camera path's at \a timeSeconds; without one, from the front and a little above so that all is seen.
CameraKey defaultView(const Painting &painting, double timeSeconds, double aspect);

} // namespace ductus
