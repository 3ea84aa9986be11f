// What changed strokes ask of the solver: the last labels and models, fitted again near the change, and
// models for what the strokes may mean. A new stroke may divide the regions it runs through; where one went,
// its neighbours may be one surface (thesis Fig. III.17: drawing the missing feature stroke).
#pragma once

#include "surfacing/refinement/scribble_effect.h"
#include "surfacing/sketch/stroke_difference.h"

namespace ductus {

struct StrokeEffect
{
    ScribbleEffect undivided; // starts from the last labels
    std::optional<ScribbleEffect>
        divided; // starts with regions parted along new strokes; nothing if none parts
};

/// \a domain holds the new association, on the same vertices as \a before; \a difference in input
/// coordinates. Locked regions are left as they are.
StrokeEffect effectOf(const ScribbleDomain &domain, const LabelSolution &before,
                      const StrokeDifference &difference, const SegmentationOptions &options);

} // namespace ductus
