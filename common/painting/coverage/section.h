// The solid of a painted stroke: a union of convex segments, one between two neighbouring points of the
// centreline. It DEFINES where a stroke is, for the CPU reference and, line by line the same, for the
// shaders. painting.md section 2; sections as in quill-and-tilt.md section 2.
//
// A segment has an axis from a to b, half widths rA and rB there, and two clip planes: nA through a and nB
// through b (unit normals that look along the stroke, or zero for "no plane"). A point x is on the right side
// if  fA = (x - a).nA >= -slack  and  fB = (x - b).nB <= slack,  slack = seamSlack * max(rA, rB). Where a
// stroke is smooth neighbours share the mitre plane between them, so that nearly every point belongs to one
// segment.
//
//   parameter  t(x) = clamp(fA / (fA - fB), 0, 1), 1/2 if fA - fB <= 0. Without a plane at a, fA is y;
//   without
//              one at b, fB is y - L, with L = |b - a| and y the place along the axis: of flat segments
//              y = (x - a).axis; of round ones where the mantle's normal through x meets the axis,
//              y = (x - a).axis - rho sin / sqrt(1 - sin^2), sin = (rA - rB) / L, rho the distance from the
//              axis (where one ball holds the other: y = 0 if rA >= rB, else y = L). It is continuous across
//              joints, and on a ball that two segments share both say the same. Colour, opacity and reach
//              direction at x are mixed linearly by t.
//   Round      convex hull of the balls (a, rA) and (b, rB), cut by the planes. Ends have no plane: a ball.
//   Ellipse,   with local coordinates x - a = tau (b - a) + u U + v V and r(tau) = rA + tau (rB - rA),
//              but no larger than max(rA, rB):
//   Cube       Ellipse  u^2 + (v / 0.3)^2 <= r^2, r >= 0.   Cube  |u| <= r, |v| <= r.   Both cut by the
//   planes.
//              U and V are unit and perpendicular, V is the thin axis; b - a may be oblique to them.
//   Ribbon     no inside: the triangles (A-, A+, B+), (A-, B+, B-) with A+- = a +- rA U, B+- = b +- rB V.
//              No planes (V is the cross direction at b here; neighbours share these edges).
//
// A line o + s d meets the convex solid in one interval [s0, s1] (segmentInterval). Everything follows:
//   inside             x is in some segment's solid (segmentContains)
//   tolerance Surface  some segment's interval along the line x + s g(x), g = unit mix of the reach
//                      directions, overlaps [-d, d]: x lies in the solid swept from -d g to +d g. Since g
//                      does not look at the view, nor at normals of the substrate, marks stay put and have no
//                      gaps, and nothing further than d from the solid is reached.
//   tolerance View     the interval along the view ray, in depth, overlaps the substrate's depth +- d
//   substrate's point  the first crossing of the skin (segmentSurface): of the body on the right side of
//                      the planes, or of a plane with its cap flag inside the body and on the right side of
//                      the other plane; not of planes that neighbours share. Drawn from both sides.
//
// Of the segments of ONE stroke that cover a point, the first along the stroke gives colour and opacity.
#pragma once

#include "geometry/triangle_mesh.h"
#include "painting/scene/element.h"

#include <cstdint>
#include <optional>
#include <utility>

namespace ductus {

/// Thickness of Quill's ellipse as a share of its width.
inline constexpr float ellipseThickness = 0.3f;

/// Share of the larger half width by which neighbours overlap at the plane they share, so that rounding
/// leaves no pinholes in the skin.
inline constexpr float seamSlack = 1e-3f;

/// Ten blocks of four floats: goes to the graphics card as it is (std430). Scene units.
struct SegmentData
{
    static constexpr std::uint32_t capAtA = 1; // the plane at a is skin: the stroke ends there
    static constexpr std::uint32_t capAtB = 2;

    Eigen::Vector3f a = Eigen::Vector3f::Zero();
    float radiusA = 0;
    Eigen::Vector3f b = Eigen::Vector3f::Zero();
    float radiusB = 0;
    Eigen::Vector3f u = Eigen::Vector3f::UnitX();
    std::uint32_t section = 0; // StrokeSection
    Eigen::Vector3f v = Eigen::Vector3f::UnitY();
    std::uint32_t caps = 0;                          // capAtA | capAtB
    Eigen::Vector3f clipA = Eigen::Vector3f::Zero(); // nA
    float opacityA = 1;
    Eigen::Vector3f clipB = Eigen::Vector3f::Zero(); // nB
    float opacityB = 1;
    Eigen::Vector3f reachA = Eigen::Vector3f::Zero(); // unit, or zero where tolerance is 0
    std::uint32_t element = 0;                        // for the caller: place of the stroke in its layer
    Eigen::Vector3f reachB = Eigen::Vector3f::Zero();
    std::uint32_t pointIndex = 0;                      // of a in StrokeShape::points
    Eigen::Vector3f colourA = Eigen::Vector3f::Zero(); // linear RGB
    float unusedA = 0;
    Eigen::Vector3f colourB = Eigen::Vector3f::Zero();
    float unusedB = 0;

    StrokeSection kind() const { return StrokeSection(section); }
};
static_assert(sizeof(SegmentData) == 10 * 16);

/// Parameters s0 <= s1 of a line.
using Interval = std::pair<double, double>;

/// t(x), see above.
double segmentParameter(const SegmentData &segment, const Vec3 &x);

/// False for ribbons.
bool segmentContains(const SegmentData &segment, const Vec3 &x);

/// Where the line origin + s direction is in the solid; of ribbons the point where it passes, s0 = s1.
/// \a direction need not be unit; zero gives none.
std::optional<Interval> segmentInterval(const SegmentData &segment, const Vec3 &origin,
                                        const Vec3 &direction);

/// The smallest s >= \a from where the line crosses the skin.
std::optional<double> segmentSurface(const SegmentData &segment, const Vec3 &origin, const Vec3 &direction,
                                     double from);

/// g(x): the unit direction of reach at \a x; zero if the segment has none.
Vec3 segmentReach(const SegmentData &segment, const Vec3 &x);

/// Tolerance in mode Surface: \a x is in the solid or in what is swept from -d g to +d g.
bool segmentReaches(const SegmentData &segment, const Vec3 &x, double tolerance);

struct SegmentBounds
{
    Vec3 centre;
    std::array<Vec3, 3> halfAxes; // the box is centre +- each of them
    Box3 box() const;
};

/// A box around the solid, and around what it reaches: an oriented one, to be drawn or put into a tree.
SegmentBounds segmentBounds(const SegmentData &segment, double tolerance = 0);

} // namespace ductus
