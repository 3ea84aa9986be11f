// A scribble solved: Algorithm 1 from its relabelling on, with the labels and models there are (thesis Sec.
// III.6), on a graph made small away from strokes and scribbles.
#pragma once

#include "surfacing/refinement/scribble_effect.h"

namespace ductus {

Result<ModelLabeling> warmStarted(const ScribbleDomain &domain, ScribbleEffect effect,
                                  const SegmentationOptions &options, const JobControl &control,
                                  int &iterations);

} // namespace ductus
