// Things to put before the camera of a bundled clip: calmer to look at than those of clip_scenes.h, with just
// enough grain that they can be followed.
#pragma once

#include "support/clip_scenes.h"

namespace ductus {

/// 0xrrggbb with a little of \a contrast, 0..1.
ClipTexture calmTexture(std::uint32_t seed, unsigned rgb, double patchSize = 0.35, double contrast = 0.3);

/// A sheet that faces the first camera, upright. World as in clip_scenes.h: y down, z away.
ClipPanel uprightPanel(const Vec3 &centre, double halfWidth, double halfHeight, const ClipTexture &texture);
ClipPanel discPanel(const Vec3 &centre, double radius, const ClipTexture &texture);
ClipPanel groundPanel(double y, double halfWidth, double zFrom, double zTo, const ClipTexture &texture);

/// Six sides around \a centre, turned about the upright axis.
ClipBody boxBody(const Vec3 &centre, const Vec3 &half, double turn, const ClipTexture &texture);

/// A camera held by hand that goes and turns evenly from one end of the clip to the other. \a down: it looks
/// down by so much, radians. Where both places are one it stands on a tripod and does not sway.
std::function<ShotCamera(int)> cameraPath(const ClipScene &scene, const Vec3 &from, const Vec3 &to,
                                          double turnFrom, double turnTo, double down);

} // namespace ductus
