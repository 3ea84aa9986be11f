// Draws the elements of a layer, strokes and meshes in their order, as what they are in it.
#pragma once

#include "render/passes/frame_context.h"

namespace ductus {

/// As the shape: into the substrate's target.
/// \a peel: how many surfaces lie before what is to be drawn; their elements are in the peeled textures.
Result<void> drawSubstrate(FrameContext &frame, const DrawnLayer &layer, int peel, bool peeling);

/// As colour of what lies inside or near, into the layer's target.
Result<void> drawAppearance(FrameContext &frame, const DrawnLayer &layer, const LayerInView &inView,
                            StackId onlyStack);

/// As places where a mask's strokes are, into the coverage target.
Result<void> drawCoverage(FrameContext &frame, const DrawnLayer &layer, const LayerInView &inView,
                          StackId onlyStack);

/// What is in view of a layer that is a shape, or of one that colours.
LayerInView lookAt(const FrameContext &frame, const DrawnLayer &layer, bool isSubstrate);

/// By how much the elements of a layer reach beyond themselves.
double reachMargin(const FrameContext &frame, const DrawnLayer &layer);

} // namespace ductus
