// Which strokes an unmarked sketch was bordered with: those that run along the cut around everything drawn. A
// designer outlines an open surface; strokes across it end at the outline or a little beyond it.
#pragma once

#include "surfacing/association/association.h"

namespace ductus {

struct BorderStrokeOptions
{
    double reach = 0.07;        // between a stroke along the border and what lies beyond: the first cut goes
                                // around strokes that stick out, so that it lies farther off than they do
    double leastShare = 0.6;    // of a stroke's crossings so near: strokes across the surface have fewer
    double leastExtent = 0.08;  // rivets along a rim are no border
    double mostApproach = 0.35; // how much nearer one end may come than the other, share of the extent
};

/// One flag a stroke of \a strokes. \a isBeyond: the vertices of \a proxy outside of the first cut, and its
/// own border. All in the unit frame, as the lengths among the options.
std::vector<char> strokesAlongBorder(const TriangleMesh &proxy, const MeshTopology &topology,
                                     const Association &association, const StrokeSet &strokes,
                                     const std::vector<char> &isBeyond, const BorderStrokeOptions &options);

/// \a flags with all vertices within \a rings edges of those flagged.
std::vector<char> grownByRings(std::vector<char> flags, const MeshTopology &topology, int rings);

} // namespace ductus
