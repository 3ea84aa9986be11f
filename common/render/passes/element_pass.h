// Draws the elements of a layer, strokes and meshes in their order, as what they are in it.
#pragma once

#include "render/passes/frame_context.h"

namespace ductus {

/// As the shape: into the substrate's target.
/// \a peel: how many surfaces lie before what is to be drawn; their elements are in the peeled textures.
Result<void> drawSubstrate(FrameContext &frame, const DrawnLayer &layer, int peel, bool peeling);

/// How strokes that colour are drawn.
struct StrokeInk
{
    bool onlyFirst =
        false;        // of a layer's strokes the one that is drawn first at a place is the only one there
    double share = 1; // of their opacity
};

/// As colour of what lies inside or near, onto what is bound.
Result<void> drawAppearance(FrameContext &frame, const DrawnLayer &layer, const LayerInView &inView,
                            StackId onlyStack, const StrokeInk &ink);

/// As places where a mask's strokes are, into the coverage target.
Result<void> drawCoverage(FrameContext &frame, const DrawnLayer &layer, const LayerInView &inView,
                          StackId onlyStack);

/// What is in view of a layer that colours; \a isBackwards: from the last element to the first.
LayerInView lookAtAppearance(const FrameContext &frame, const DrawnLayer &layer, bool isBackwards = false);

/// By how much the elements of a layer reach beyond themselves.
double reachMargin(const FrameContext &frame, const DrawnLayer &layer);

} // namespace ductus
