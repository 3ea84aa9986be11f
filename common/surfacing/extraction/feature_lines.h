// Creases of the optimised mesh as polylines: seam edges whose ends are both sharp, chained.
#pragma once

#include "surfacing/extraction/seam_insertion.h"

namespace ductus {

/// \a sharpness: 1 - w_v, one a vertex. Lines end at junctions; closed ones repeat their first vertex.
std::vector<std::vector<int>> featureLines(const SeamedMesh &seamed, const std::vector<double> &sharpness);

} // namespace ductus
