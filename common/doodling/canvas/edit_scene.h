// Edits of canvases as functions from the old scene to the new one. What cannot be done is refused with
// InvalidArgument and changes nothing.
#pragma once

#include "doodling/canvas/canvas.h"

namespace ductus {

/// \a canvas gets an id nobody has and goes on top. Refused without a position keyframe or with sizes or an
/// opacity that are none.
Result<DoodleScene> withCanvas(const DoodleScene &scene, Canvas canvas);

/// \a canvas takes the place of the one with its id. Refused like withCanvas(), and if there is none.
Result<DoodleScene> withChangedCanvas(const DoodleScene &scene, Canvas canvas);

Result<DoodleScene> withoutCanvas(const DoodleScene &scene, CanvasId id);

/// The canvas at \a index of the order, 0: lowest.
Result<DoodleScene> withMovedCanvas(const DoodleScene &scene, CanvasId id, int index);

/// A keyframe that takes the place of one in the same frame. Refused in frames below zero and for depths and
/// scales that are not positive.
Result<Canvas> withPosition(const Canvas &canvas, const CanvasKeyframe &keyframe);
Result<Canvas> withDepth(const Canvas &canvas, const DepthKeyframe &keyframe);
Result<Canvas> withTurn(const Canvas &canvas, const TurnKeyframe &keyframe);
Result<Canvas> withScale(const Canvas &canvas, const ScaleKeyframe &keyframe);

enum class KeyframeKind { Position, Depth, Turn, Scale };

/// Refused if there is none in the frame, and for the last position.
Result<Canvas> withoutKeyframe(const Canvas &canvas, KeyframeKind kind, int frame);
/// Refused if there is none in \a from, or one in \a to.
Result<Canvas> withMovedKeyframe(const Canvas &canvas, KeyframeKind kind, int from, int to);
/// Whether the canvas goes straight to the next keyframe (true) or follows the scene. Position and Turn only.
Result<Canvas> withInterpolation(const Canvas &canvas, KeyframeKind kind, int frame, bool interpolates);

} // namespace ductus
