#include "surfacing/proxy/flat_ends.h"

#include "geometry/nearest.h"
#include "strokes/resample.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace ductus {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr int directions = 72;
constexpr double sampleStep = 0.0025; // less than a direction's width along the least outline

struct Plane
{
    Vec3 centre, normal, u, v;
    double halfWidth = 0.0, lesserHalfWidth = 0.0, meanDistance = 0.0;

    double height(const Vec3 &p) const { return normal.dot(p - centre); }
    Vec2 across(const Vec3 &p) const { return {u.dot(p - centre), v.dot(p - centre)}; }
    Vec3 at(const Vec2 &p) const { return centre + p.x() * u + p.y() * v; }
};

Plane planeOf(const std::vector<Vec3> &points)
{
    Plane plane;
    plane.centre = Vec3::Zero();
    for (const Vec3 &p : points)
        plane.centre += p / double(points.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const Vec3 &p : points)
        scatter += (p - plane.centre) * (p - plane.centre).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
    plane.normal = axes.eigenvectors().col(0);
    plane.u = axes.eigenvectors().col(2);
    plane.v = plane.normal.cross(plane.u);
    for (const Vec3 &p : points) {
        plane.halfWidth = std::max(plane.halfWidth, std::abs(plane.across(p).x()));
        plane.lesserHalfWidth = std::max(plane.lesserHalfWidth, std::abs(plane.across(p).y()));
        plane.meanDistance += std::abs(plane.height(p)) / double(points.size());
    }
    return plane;
}

bool isFlatAndWide(const Plane &plane, const FlatEndOptions &options)
{
    return plane.halfWidth >= options.leastSize &&
           plane.lesserHalfWidth >= options.leastRoundness * plane.halfWidth &&
           plane.meanDistance <= options.imprecision + options.flatness * plane.halfWidth;
}

// Samples of one stroke each.
using Drawn = std::vector<std::vector<Vec3>>;

bool liesIn(const Plane &plane, const std::vector<Vec3> &stroke, double tolerance)
{
    const auto in = std::count_if(stroke.begin(), stroke.end(),
                                  [&](const Vec3 &p) { return std::abs(plane.height(p)) < tolerance; });
    return double(in) >= 0.9 * double(stroke.size());
}

bool isNear(const Vec3 &end, const std::vector<Vec3> &points, double distance)
{
    return std::any_of(points.begin(), points.end(),
                       [&](const Vec3 &p) { return (p - end).squaredNorm() < distance * distance; });
}

// Strokes of the plane that lie in it, from those at the start on to all that carry the outline on.
std::vector<Vec3> carriedOn(const Drawn &drawn, const std::vector<Vec3> &start, const Plane &plane,
                            double tolerance, double reach)
{
    std::vector<Vec3> outline = start;
    std::vector<char> isTaken(drawn.size(), 0);
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t s = 0; s < drawn.size(); ++s) {
            if (isTaken[s] || !liesIn(plane, drawn[s], tolerance) ||
                !(isNear(drawn[s].front(), outline, reach) || isNear(drawn[s].back(), outline, reach)))
                continue;
            outline.insert(outline.end(), drawn[s].begin(), drawn[s].end());
            isTaken[s] = 1;
            grows = true;
        }
    }
    return outline;
}

// How far the outline is from its middle in each direction; 0 where nothing is drawn.
using Radii = std::array<double, directions>;

int directionOf(const Vec2 &p)
{
    const double turn = std::atan2(p.y(), p.x()) / (2.0 * std::numbers::pi) + 0.5;
    return std::clamp(int(turn * directions), 0, directions - 1);
}

int longestGap(const Radii &radii)
{
    int longest = 0, gap = 0;
    for (int turn = 0; turn < 2 * directions; ++turn) {
        gap = radii[std::size_t(turn % directions)] > 0.0 ? 0 : gap + 1;
        longest = std::max(longest, gap);
    }
    return longest;
}

struct Outline
{
    Plane plane;
    Radii radii;
    std::vector<Vec3> points;

    bool isInside(const Vec2 &p, double share) const
    {
        return p.norm() < share * radii[std::size_t(directionOf(p))];
    }
};

// Nearly all of it lies at one distance in each direction: no tangle of strokes that share a plane.
bool goesOnceRound(const Outline &outline, double raggedness)
{
    const auto ragged = std::count_if(outline.points.begin(), outline.points.end(), [&](const Vec3 &p) {
        const Vec2 q = outline.plane.across(p);
        const double radius = outline.radii[std::size_t(directionOf(q))];
        return std::abs(q.norm() - radius) > raggedness * radius;
    });
    return double(ragged) <= 0.1 * double(outline.points.size());
}

std::optional<Outline> outlineAround(const std::vector<Vec3> &points, const FlatEndOptions &options)
{
    Outline outline{planeOf(points), {}, points};
    const Plane &plane = outline.plane;
    if (!isFlatAndWide(plane, options))
        return std::nullopt;
    Radii &radii = outline.radii;
    std::array<int, directions> counts{};
    radii.fill(0.0);
    for (const Vec3 &p : points) {
        const Vec2 q = plane.across(p);
        const std::size_t d = std::size_t(directionOf(q));
        radii[d] += (q.norm() - radii[d]) / ++counts[d];
    }
    const auto drawn = std::count_if(radii.begin(), radii.end(), [](double r) { return r > 0.0; });
    if (double(drawn) < options.coverage * directions || longestGap(radii) > options.longestGap * directions)
        return std::nullopt;
    if (!goesOnceRound(outline, options.raggedness))
        return std::nullopt;
    for (int turn = 0; turn < 2 * directions; ++turn)
        if (double &r = radii[std::size_t(turn % directions)]; r == 0.0)
            r = radii[std::size_t((turn + directions - 1) % directions)];
    return outline;
}

// Nothing drawn says that the end is a dome or a dent.
bool isFree(const Outline &outline, int side, const Drawn &drawn, double tolerance,
            const FlatEndOptions &options)
{
    const Plane &plane = outline.plane;
    for (const std::vector<Vec3> &stroke : drawn)
        for (const Vec3 &p : stroke) {
            const double height = side * plane.height(p);
            if (height < options.freeHeight * plane.halfWidth &&
                height > -options.freeDepth * plane.halfWidth && std::abs(height) > tolerance &&
                outline.isInside(plane.across(p), options.innerShare))
                return false;
        }
    return true;
}

// As high as the outline around it, its near parts first.
double heightInside(const Outline &outline, const Vec2 &place)
{
    double sum = 0.0, weights = 0.0;
    for (const Vec3 &p : outline.points) {
        const double weight = 1.0 / ((outline.plane.across(p) - place).squaredNorm() + 1e-6);
        sum += weight * outline.plane.height(p);
        weights += weight;
    }
    return sum / weights;
}

std::vector<Vec3> pointsInside(const Outline &outline, double spacing)
{
    std::vector<Vec3> points;
    const int n = int(std::ceil(1.5 * outline.plane.halfWidth / spacing));
    for (int i = -n; i <= n; ++i)
        for (int j = -n; j <= n; ++j)
            if (const Vec2 p = spacing * Vec2(i + 0.5 * (j & 1), 0.866 * j); outline.isInside(p, 0.92))
                points.push_back(outline.plane.at(p) + heightInside(outline, p) * outline.plane.normal);
    return points;
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

// +1 or -1: the side of the plane that is outside while the solid lies on the other one; 0 within the solid
// or away from it.
int outerSide(const Plane &plane, const std::vector<Vec3> &inside, const NearestOnMesh &wrap,
              double wrapOffset)
{
    const double nearest = 1.5 * wrapOffset, farthest = std::max(nearest, 0.5 * plane.lesserHalfWidth);
    const int above = pointsOver(wrap, inside, plane.normal, nearest, farthest),
              below = pointsOver(wrap, inside, -plane.normal, nearest, farthest);
    const int few = int(inside.size()) / 5, most = int(inside.size()) * 4 / 5;
    return above <= few && below >= most ? 1 : below <= few && above >= most ? -1 : 0;
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
    const Plane rough = planeOf(start);
    if (!isFlatAndWide(rough, options))
        return std::nullopt;
    const double tolerance = std::max(options.tolerance, options.toleranceShare * rough.halfWidth);
    const std::optional<Outline> outline =
        outlineAround(carriedOn(drawn, start, rough, tolerance, options.reach), options);
    if (!outline)
        return std::nullopt;
    const Plane &plane = outline->plane;
    std::vector<Vec3> inside = pointsInside(*outline, options.spacing);
    const int side = outerSide(plane, inside, wrap, wrapOffset);
    if (side == 0 || inside.empty() || !isFree(*outline, side, drawn, tolerance, options))
        return std::nullopt;
    return FlatEnd{plane.centre, side * plane.normal, std::move(inside), options.spacing};
}

} // namespace

std::vector<FlatEnd> flatEndsOf(const StrokeSet &strokes, const Wrap &wrap, const FlatEndOptions &options)
{
    const Drawn drawn = drawnStrokes(strokes);
    const NearestOnMesh nearestWrap(wrap.mesh);
    std::vector<FlatEnd> ends;
    for (const std::vector<Vec3> &stroke : drawn) {
        const Plane rough = planeOf(stroke);
        if (isAmong(ends, rough.centre, rough.normal))
            continue;
        std::optional<FlatEnd> end = flatEndFrom(stroke, drawn, nearestWrap, wrap.offset, options);
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
