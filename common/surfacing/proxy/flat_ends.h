// Flat ends of a solid that are drawn by their outline alone: the bottom of a bottle, the top of its cork.
// Nothing inside the outline says that the end is flat, and the smoothest field through the strokes bulges
// out there, so that it becomes a bullet without the crease that was drawn. But a designer who wanted a dome
// would have drawn its profile: points across the outline hold the field to its plane.
//
// Beyond the thesis, which takes the proxy as it comes (Sec. III.6).
#pragma once

#include "strokes/stroke.h"
#include "surfacing/proxy/wrap_proxy.h"

namespace ductus {

/// Lengths in the unit frame.
struct FlatEndOptions
{
    double leastSize = 0.04;     // greater half-width of an outline; smaller ones hardly bulge
    double leastRoundness = 0.2; // lesser half-width by the greater one
    double flatness = 0.03;      // greatest mean distance from the plane, share of the greater half-width ...
    double imprecision = 0.003;  // ... besides people's imprecision
    double tolerance = 0.012;    // strokes this near the plane lie in it: people's imprecision ...
    double toleranceShare = 0.08; // ... and more for great outlines, share of the greater half-width
    double reach = 0.03;          // strokes in the plane whose end is so near carry the outline on
    double coverage = 0.9;        // of the way round that is drawn ...
    double longestGap = 0.06;     // ... and what may be missing in one place
    double raggedness = 0.12;     // how far it strays from its mean distance in a direction, share of that
    double innerShare = 0.85;     // of the outline's radius; what is farther in lies inside
    double freeHeight = 0.6; // no stroke stands so high above the inside, share of the greater half-width
    double freeDepth = 0.15; // nor so shallow below it
    double spacing = 0.025;  // of the points that hold the end flat
};

struct FlatEnd
{
    Vec3 centre = Vec3::Zero();
    Vec3 outwards = Vec3::UnitZ();
    std::vector<Vec3> inside; // evenly between the outline's sides, as high as it is around them
    double spacing = 0.0;     // of these
};

/// \a strokes and \a wrap in the unit frame; of a solid.
std::vector<FlatEnd> flatEndsOf(const StrokeSet &strokes, const Wrap &wrap, const FlatEndOptions &options);

/// Those of \a ends that \a drawn, points of strokes drawn since, do not contradict.
std::vector<FlatEnd> stillFlat(const std::vector<FlatEnd> &ends, const std::vector<Vec3> &drawn,
                               const FlatEndOptions &options);

} // namespace ductus
