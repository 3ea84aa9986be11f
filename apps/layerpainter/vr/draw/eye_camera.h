// From where an eye sees the painting.
#pragma once

#include "layerpainter/vr/hands/hand_input.h"
#include "layerpainter/vr/session/headset_session.h"
#include "painting/reference/frame_camera.h"
#include "painting/scene/placement.h"

namespace ductus {

RoomPose roomPose(const XrPosef &pose);

/// In metres, the room as the scene.
FrameCamera roomCamera(const EyeView &eye);

/// The same eye in the painting that stands at \a roomFromScene.
FrameCamera sceneCamera(const EyeView &eye, const Placement &roomFromScene);

/// Where a painting stands at first: what the window shows from \a camera is seen from where the user stands,
/// upright, in its own size (\a metresPerUnit) or, if that is hardly a room's (\a diagonal, scene units), in
/// one that is.
Placement firstPlacement(const CameraKey &camera, double diagonal, double metresPerUnit);

} // namespace ductus
