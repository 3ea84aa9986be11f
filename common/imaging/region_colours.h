// Colours for regions: twenty that stay apart for people with and without full colour vision, handed out so
// that neighbours never share one.
#pragma once

#include "imaging/image.h"

#include <utility>
#include <vector>

namespace ductus {

inline constexpr int regionColourCount = 20;

/// Colour number \a index; beyond 0..19 they repeat (also for negative numbers). Opaque.
Rgba regionColour(int index);

/// A colour number for each of \a regionCount regions such that the two of every pair in \a neighbours
/// differ, and look as different as the free choice allows. Deterministic; equal input order does not matter.
/// Should a region have 20 differently coloured neighbours already, numbers beyond 19 are used: they differ
/// as numbers.
std::vector<int> assignRegionColours(int regionCount, const std::vector<std::pair<int, int>> &neighbours);

/// CIE76 distance of two colours in L*a*b*; about 2.3 is just noticeable.
double colourDistance(Rgba a, Rgba b);

/// What a person without red (0), green (1) or blue (2) cones sees [Vienot, Brettel, Mollon 1999; Brettel
/// 1997].
Rgba asSeenByColourBlind(Rgba colour, int missingCone);

} // namespace ductus
