// Mirror planes: detection of the one a sketch was drawn with, and cutting sketches in half (thesis Sec. III.6,
// Symmetric sketches).
#pragma once

#include "strokes/stroke.h"

#include <optional>

namespace ductus {

/// normal . x = offset; the side with normal . x >= offset is the one that is solved.
struct SymmetryPlane
{
    Vec3 normal = Vec3::UnitX(); // unit
    double offset = 0.0;

    double signedDistance(const Vec3 &x) const { return normal.dot(x) - offset; }
    Vec3 mirrored(const Vec3 &x) const { return x - 2.0 * signedDistance(x) * normal; }
    Vec3 projected(const Vec3 &x) const { return x - signedDistance(x) * normal; }
};

struct SymmetryProposal
{
    SymmetryPlane plane;
    double matchedShare = 0.0; // of stroke samples whose mirror image lies on a stroke, 0..1
    double residual = 0.0;     // their median distance, in the set's unit
};

struct SymmetryOptions
{
    double tolerance = 0.012;  // of a match, share of the box diagonal
    double neededShare = 0.85; // of matched samples
};

/// The best mirror plane if one is good enough: tried are the coordinate axes and the principal axes, each refined.
std::optional<SymmetryProposal> detectSymmetry(const StrokeSet &strokes, const SymmetryOptions &options);

/// The plane turned so that its kept side holds at least half of the stroke length.
SymmetryPlane towardsFullerSide(const SymmetryPlane &plane, const StrokeSet &strokes);

/// Strokes cut at the plane, only the parts on its kept side (and in it). Ids and roles are kept; a stroke cut
/// several times gives several with the same id.
StrokeSet keptHalf(const StrokeSet &strokes, const SymmetryPlane &plane);

/// \a half and its mirror image, for stages that need the whole shape.
StrokeSet withMirrorImage(const StrokeSet &half, const SymmetryPlane &plane);

} // namespace ductus
