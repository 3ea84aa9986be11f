// Which way the strokes of a layer with tolerance reach: towards the nearest substrate, smoothed along the
// stroke. painting.md section 2, tolerance mode "surface".
#pragma once

#include "painting/coverage/layer_solid.h"

namespace ductus {

/// Sets reachA and reachB of all segments of \a layer. At places along each stroke, half its greatest half
/// width apart, the direction a across the nearest skin of \a substrates is looked up (segment_distance.h);
/// the reach at a place is the principal direction of the sum of a a^T with Gaussian weights along the
/// stroke, sigma = 2 max(greatest half width, tolerance), so that it neither jumps from bump to bump nor
/// cares for the sign of a. Without a substrate it is across the stroke. To be called again when either
/// moves.
void setReach(LayerSolid &layer, const std::vector<const LayerSolid *> &substrates);

} // namespace ductus
