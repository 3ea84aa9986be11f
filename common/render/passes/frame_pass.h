// One frame of a painting from its passes: the only place that knows their order. painting.md sections 2, 3.
//
//     substrates                     what is seen: colour, stack, element, depth
//     each stack, then the scene:    each layer bottom to top (appearance_pass.h):
//         strokes                    the layer's own premultiplied colour, in drawing order
//         masks                      their product
//         composite                  onto the frame
//     accumulate                     only with translucent substrates: the next surface behind, again
#pragma once

#include "render/passes/mask_pass.h"

namespace ductus {

/// Draws into the frame's buffers.
Result<void> drawFrame(FrameContext &frame, MaskBlocks &blocks);

/// Whether the painting has translucent substrates: the frame then is in FrameBuffers::accumulated.
bool needsPeeling(const PaintingUpload &painting);

/// The frame as straight sRGB onto what is bound for drawing, with its lower left corner at (\a x, \a y).
/// \a transparent leaves out the background.
Result<void> presentFrame(FrameContext &frame, bool transparent, int x, int y);

} // namespace ductus
