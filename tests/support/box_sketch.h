// A box drawn by its edges and two lines across each face in both directions: the least sketch with creases.
#pragma once

#include "strokes/stroke.h"

#include <functional>

namespace ductus {

struct BoxSketchOptions
{
    Vec3 halfBox = Vec3(0.5, 0.32, 0.4);
    double lineShare = 0.35; // of the half box: how far the lines across faces lie from the middle
    double step = 0.03;      // of points along strokes
    std::function<bool(const Vec3 &, const Vec3 &)>
        isLeftOut; // by its ends in the box of half size 1; empty: none
};

/// About the origin; ids 0, 1, ...
StrokeSet boxSketch(const BoxSketchOptions &options = {});

/// A straight stroke.
Stroke straightStroke(const Vec3 &a, const Vec3 &b, double step);

} // namespace ductus
