// Which strokes an unmarked sketch was bordered with: those that run along the cut around everything drawn. A
// designer outlines an open surface; strokes across it end at the outline or a little beyond it.
#pragma once

#include "surfacing/association/association.h"

namespace ductus {

struct BorderStrokeOptions
{
    int reachRings = 3;        // edges between a stroke along the border and what lies beyond
    double leastShare = 0.6;   // of a stroke's crossings so near: strokes across the surface have fewer
    double leastExtent = 0.08; // share of the sketch's diagonal: rivets along a rim are no border
};

/// One flag a stroke of \a strokes (unit frame). \a isBeyond: the vertices outside of the first cut, and the
/// proxy's own border.
std::vector<char> strokesAlongBorder(const MeshTopology &topology, const Association &association,
                                     const StrokeSet &strokes, const std::vector<char> &isBeyond,
                                     const BorderStrokeOptions &options);

/// \a flags with all vertices within \a rings edges of those flagged.
std::vector<char> grownByRings(std::vector<char> flags, const MeshTopology &topology, int rings);

} // namespace ductus
