// Flat ends of a solid that are drawn by their outline alone: the bottom of a bottle, the top of its cork.
// Nothing inside the outline says that the end is flat, and the smoothest field through the strokes bulges
// out there, so that it becomes a bullet without the crease that was drawn. But a designer who wanted a dome
// would have drawn its profile: points across the outline hold the field to its plane. An outline is found
// from a stroke that shows its plane by itself, or as strokes in one plane of the convex hull (the floor of a
// car).
//
// Beyond the thesis, which takes the proxy as it comes (Sec. III.6).
#pragma once

#include "strokes/stroke.h"
#include "surfacing/proxy/outline.h"
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
    OutlineDemands drawnOutline{0.9, 0.06}; // found from a stroke that shows the plane by itself
    OutlineDemands hullOutline{0.8, 0.1};   // on the convex hull, which is evidence of an end by itself
    double leastHullArea = 0.0025;          // of a triangle of the hull that may show an end
    double innerShare = 0.85;               // of the outline's radius; what is farther in lies inside
    double freeHeight = 0.6;   // no stroke stands so high above the inside, share of the greater half-width
    double freeDepth = 0.15;   // nor so shallow below it, ...
    double shallowSlope = 0.6; // ... or by its distance from the outline
    double spacing = 0.025;    // of the points that hold an end flat
    double hullSpacing =
        0.12; // and of those on the hull, which may be great: share of the greater half-width
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
