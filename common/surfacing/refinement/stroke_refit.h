// The regions of a proxy after strokes were added, removed or moved: warm-started from those before.
#pragma once

#include "surfacing/refinement/refinement.h"
#include "surfacing/sketch/stroke_difference.h"

namespace ductus {

/// \a domain: with the new association, on the same vertices as \a known; \a difference in input coordinates, only
/// the solved half.
/// Scribbles hold on as constraints and are not applied anew: a seam drawn once is a stroke that came later
/// than the region it parted. Taking one away later goes back to the automatic solution, which is brought up
/// to date as well.
Result<std::shared_ptr<const LabelSolution>>
refitted(const ScribbleDomain &domain, const LabelSolution &known, const StrokeDifference &difference,
         const SegmentationOptions &options, const JobControl &control);

} // namespace ductus
