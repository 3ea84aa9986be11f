// Slips of the controller: dabs in the air, away from everything. Left in, they stretch the box and with it
// every length that is a share of it, and the surface grows a spike to reach them.
#pragma once

#include "strokes/stroke.h"

namespace ductus {

struct StrayOptions
{
    double largestExtent = 0.02; // of a dab: share of the diagonal of all strokes that are none
    double leastDistance = 0.06; // from those: the same share
    double largestShare = 0.25;  // of all strokes: with more, dabs are how this sketch is drawn
};

struct StraysFound
{
    StrokeSet strokes; // as given, the strays' roles Ignored
    int count = 0;
};

/// Strokes with a role given by hand (any but Surface) are no strays.
StraysFound withStraysIgnored(const StrokeSet &strokes, const StrayOptions &options = {});

} // namespace ductus
