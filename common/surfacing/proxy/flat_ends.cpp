#include "surfacing/proxy/flat_ends.h"

#include "geometry/nearest.h"
#include "strokes/resample.h"
#include "surfacing/proxy/hull_outlines.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double sampleStep = 0.0025; // less than a direction's width along the least outline

bool isFlatAndWide(const OutlinePlane &plane, const FlatEndOptions &options)
{
    return plane.halfWidth >= options.leastSize &&
           plane.lesserHalfWidth >= options.leastRoundness * plane.halfWidth &&
           plane.meanDistance <= options.imprecision + options.flatness * plane.halfWidth;
}

// Samples of one stroke each.
using Drawn = std::vector<std::vector<Vec3>>;

bool isNear(const Vec3 &end, const std::vector<Vec3> &points, double distance)
{
    return std::any_of(points.begin(), points.end(),
                       [&](const Vec3 &p) { return (p - end).squaredNorm() < distance * distance; });
}

double toleranceOf(const OutlinePlane &plane, const FlatEndOptions &options)
{
    return std::max(options.tolerance, options.toleranceShare * plane.halfWidth);
}

// Strokes of the plane that lie in it, from those at the start on to all that carry the outline on.
std::vector<Vec3> carriedOn(const Drawn &drawn, const std::vector<Vec3> &start, const OutlinePlane &plane,
                            double tolerance, double reach)
{
    std::vector<Vec3> outline = start;
    std::vector<char> isTaken(drawn.size(), 0);
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t s = 0; s < drawn.size(); ++s) {
            if (isTaken[s] || !liesInPlane(drawn[s], plane.centre, plane.normal, tolerance) ||
                !(isNear(drawn[s].front(), outline, reach) || isNear(drawn[s].back(), outline, reach)))
                continue;
            outline.insert(outline.end(), drawn[s].begin(), drawn[s].end());
            isTaken[s] = 1;
            grows = true;
        }
    }
    return outline;
}

// Nothing drawn says that the end is a dome or a dent: a stroke inside the outline that hovers above it, or
// lies so shallow below that it is no side of the solid.
bool isFree(const Outline &outline, const Vec3 &outwards, const Drawn &drawn, double tolerance,
            const FlatEndOptions &options)
{
    const OutlinePlane &plane = outline.plane;
    const double highest = options.freeHeight * plane.halfWidth,
                 deepest = options.freeDepth * plane.halfWidth;
    for (const std::vector<Vec3> &stroke : drawn)
        for (const Vec3 &p : stroke) {
            const Eigen::Vector2d q = plane.across(p);
            const double height = outwards.dot(p - plane.centre);
            if (std::abs(height) < tolerance || height > highest || !outline.isInside(q, options.innerShare))
                continue;
            const double fromOutline = outline.radiusTowards(q) - q.norm();
            if (height > -std::min(deepest, options.shallowSlope * fromOutline))
                return false;
        }
    return true;
}

// Points from which the solid is met straight on between \a nearest and \a farthest.
int pointsOver(const NearestOnMesh &wrap, const std::vector<Vec3> &points, const Vec3 &direction,
               double nearest, double farthest)
{
    return int(std::count_if(points.begin(), points.end(), [&](const Vec3 &p) {
        for (double share : {0.0, 0.2, 0.4, 0.7, 1.0})
            if (wrap.isInside(p + (nearest + share * (farthest - nearest)) * direction))
                return true;
        return false;
    }));
}

// The side of an outline that is outside while the solid lies on the other one; none within the solid or
// away from it.
std::optional<Vec3> outerSide(const OutlinePlane &plane, const std::vector<Vec3> &inside,
                              const NearestOnMesh &wrap, double wrapOffset)
{
    const double nearest = 1.5 * wrapOffset, farthest = std::max(nearest, 0.5 * plane.lesserHalfWidth);
    const int above = pointsOver(wrap, inside, plane.normal, nearest, farthest),
              below = pointsOver(wrap, inside, -plane.normal, nearest, farthest);
    const int few = int(inside.size()) / 5, most = int(inside.size()) * 4 / 5;
    if (above <= few && below >= most)
        return plane.normal;
    if (below <= few && above >= most)
        return -plane.normal;
    return std::nullopt;
}

// A hull has nothing outside; the wrap may have come in through the end that is missing, but not everywhere
// as through the hole of a ring.
bool isSolidUnder(const OutlinePlane &plane, const Vec3 &outwards, const std::vector<Vec3> &inside,
                  const NearestOnMesh &wrap, double wrapOffset)
{
    const double nearest = 1.5 * wrapOffset, farthest = std::max(nearest, 0.5 * plane.lesserHalfWidth);
    return pointsOver(wrap, inside, -outwards, nearest, farthest) >= int(inside.size()) * 4 / 5;
}

Drawn drawnStrokes(const StrokeSet &strokes)
{
    Drawn drawn;
    for (const Stroke &stroke : strokes.strokes)
        if (stroke.role == StrokeRole::Surface && stroke.points.size() > 1)
            drawn.push_back(resampled(stroke.points, sampleStep));
    return drawn;
}

bool isAmong(const std::vector<FlatEnd> &ends, const Vec3 &centre, const Vec3 &normal)
{
    return std::any_of(ends.begin(), ends.end(), [&](const FlatEnd &end) {
        return std::abs(end.outwards.dot(normal)) > 0.97 && isNear(centre, end.inside, 1.5 * end.spacing);
    });
}

// The end whose outline \a start is, or is a part of.
std::optional<FlatEnd> flatEndFrom(const std::vector<Vec3> &start, const Drawn &drawn,
                                   const NearestOnMesh &wrap, double wrapOffset,
                                   const FlatEndOptions &options)
{
    const OutlinePlane rough = planeThrough(start);
    if (!isFlatAndWide(rough, options))
        return std::nullopt;
    const double tolerance = toleranceOf(rough, options);
    const std::optional<Outline> outline =
        outlineThrough(carriedOn(drawn, start, rough, tolerance, options.reach), options.drawnOutline);
    if (!outline || !isFlatAndWide(outline->plane, options))
        return std::nullopt;
    std::vector<Vec3> inside = pointsInside(*outline, options.spacing);
    const std::optional<Vec3> outwards = outerSide(outline->plane, inside, wrap, wrapOffset);
    if (!outwards || inside.empty() || !isFree(*outline, *outwards, drawn, tolerance, options))
        return std::nullopt;
    return FlatEnd{outline->plane.centre, *outwards, std::move(inside), options.spacing};
}

std::optional<FlatEnd> flatEndOnHull(const HullOutline &found, const Drawn &drawn, const NearestOnMesh &wrap,
                                     double wrapOffset, const FlatEndOptions &options)
{
    const std::optional<Outline> outline = outlineThrough(found.points, options.hullOutline);
    if (!outline || !isFlatAndWide(outline->plane, options))
        return std::nullopt;
    const double spacing = std::max(options.spacing, options.hullSpacing * outline->plane.halfWidth);
    std::vector<Vec3> inside = pointsInside(*outline, spacing);
    if (inside.empty() || !isSolidUnder(outline->plane, found.outwards, inside, wrap, wrapOffset) ||
        !isFree(*outline, found.outwards, drawn, toleranceOf(outline->plane, options), options))
        return std::nullopt;
    return FlatEnd{outline->plane.centre, found.outwards, std::move(inside), spacing};
}

} // namespace

std::vector<FlatEnd> flatEndsOf(const StrokeSet &strokes, const Wrap &wrap, const FlatEndOptions &options)
{
    const Drawn drawn = drawnStrokes(strokes);
    const NearestOnMesh nearestWrap(wrap.mesh);
    std::vector<FlatEnd> ends;
    for (const std::vector<Vec3> &stroke : drawn) {
        const OutlinePlane rough = planeThrough(stroke);
        if (isAmong(ends, rough.centre, rough.normal))
            continue;
        std::optional<FlatEnd> end = flatEndFrom(stroke, drawn, nearestWrap, wrap.offset, options);
        if (end && !isAmong(ends, end->centre, end->outwards))
            ends.push_back(std::move(*end));
    }
    for (const HullOutline &outline : outlinesOnHull(drawn, options.tolerance, options.leastHullArea)) {
        std::optional<FlatEnd> end = flatEndOnHull(outline, drawn, nearestWrap, wrap.offset, options);
        if (end && !isAmong(ends, end->centre, end->outwards))
            ends.push_back(std::move(*end));
    }
    return ends;
}

std::vector<FlatEnd> stillFlat(const std::vector<FlatEnd> &ends, const std::vector<Vec3> &drawn,
                               const FlatEndOptions &options)
{
    std::vector<FlatEnd> still;
    for (const FlatEnd &end : ends) {
        const bool isContradicted = std::any_of(drawn.begin(), drawn.end(), [&](const Vec3 &p) {
            const Vec3 foot = p - end.outwards.dot(p - end.centre) * end.outwards;
            return std::abs(end.outwards.dot(p - end.centre)) > options.tolerance &&
                   (p - foot).norm() < 4.0 * end.spacing && isNear(foot, end.inside, 0.6 * end.spacing);
        });
        if (!isContradicted)
            still.push_back(end);
    }
    return still;
}

} // namespace ductus
