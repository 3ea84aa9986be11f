// Cutting a connected part of a region in two along a scribble.
#pragma once

#include "surfacing/refinement/scribble_path.h"

#include <optional>

namespace ductus {

struct RegionCut
{
    std::vector<int> left, right;         // vertices of the part on either side
    std::vector<int> seamLeft, seamRight; // those next to the line
    std::vector<int> crossedEdges;        // inside the part
};

enum class CutEnds {
    AsDrawn,  // only a line that parts the region by itself
    Extended, // ends inside the region go on: to one another if the line nearly closes up, else to the
              // nearest border
};

/// \a part: vertices of the region, sorted and connected. Nothing where the line does not part it.
std::optional<RegionCut> cutAlong(const ScribbleDomain &domain, const std::vector<int> &part,
                                  const ScribblePath &path, CutEnds ends);

/// The same parts with their common border moved to strokes that run within \a reach of the line (a minimal
/// cut).
void snapToStrokes(const ScribbleDomain &domain, RegionCut &cut, double reach);

} // namespace ductus
