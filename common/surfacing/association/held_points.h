// Flat ends that nothing was drawn in (proxy/flat_ends.h) as data: their points stand in the association like
// stroke points, so that a model through the rims of a thin foot's bottom and side alone is seen to miss the
// bottom.
#pragma once

#include "geometry/nearest.h"
#include "surfacing/association/association.h"
#include "surfacing/proxy/flat_ends.h"

namespace ductus {

/// Vertices without stroke points nearest to points of \a ends get these. No sample belongs to such points:
/// they come after those of strokes, cross no edge, and do not count as pairs, since nobody drew them.
void holdFlatEnds(Association &association, const std::vector<FlatEnd> &ends, const TriangleMesh &proxy,
                  const NearestOnMesh &nearest);

} // namespace ductus
