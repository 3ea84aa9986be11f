// The layers that colour what is seen, stack by stack, then those of the scene; bottom to top.
//
// A layer's strokes first make the layer's own picture, which then is blended onto the frame. Two kinds of
// layers need no picture of their own and are drawn straight onto the frame: see WayOfDrawing.
#pragma once

#include "render/passes/mask_pass.h"

namespace ductus {

enum class WayOfDrawing {
    OwnPicture,
    /// Normal blending of the whole layer: strokes over strokes over the frame, whatever comes first.
    Straight,
    /// Opaque strokes: only the topmost one counts, and no other one is drawn at that place.
    Topmost,
};
WayOfDrawing wayOfDrawing(const DrawnLayer &layer);

/// Onto the frame's colour; its surface is known.
Result<void> drawAppearances(FrameContext &frame, MaskBlocks &blocks);

} // namespace ductus
