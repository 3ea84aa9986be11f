// Pictures of surfaces and strokes without a display or a graphics card: a small software renderer that draws
// the same bytes on every run. Clay in soft light: a shadowed key light, a sky dome (ambient occlusion), a
// fill light, a shadow on the ground, fine crease lines.
//
// Steps: stage (normals, colours) -> camera -> samples (which triangle or tube is seen where) -> light ->
// pixels.
#pragma once

#include "imaging/picture_scene.h"

namespace ductus {

/// The picture of \a scene, opaque, framed automatically. An empty scene gives the background alone. Sizes
/// and angles outside their range are clamped into it. 40,000 triangles at 1280 x 960 take about a second on
/// two cores.
Image renderPicture(const PictureScene &scene, const PictureOptions &options = {});

} // namespace ductus
