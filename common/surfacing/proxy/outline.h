// A flat closed outline and what lies inside it, seen from its middle.
#pragma once

#include "geometry/triangle_mesh.h"

#include <array>
#include <optional>

namespace ductus {

/// Through points by principal axes; \a u is the longest.
struct OutlinePlane
{
    Vec3 centre, normal, u, v;
    double halfWidth = 0.0, lesserHalfWidth = 0.0, meanDistance = 0.0;

    double height(const Vec3 &p) const { return normal.dot(p - centre); }
    Eigen::Vector2d across(const Vec3 &p) const { return {u.dot(p - centre), v.dot(p - centre)}; }
    Vec3 at(const Eigen::Vector2d &p) const { return centre + p.x() * u + p.y() * v; }
};

OutlinePlane planeThrough(const std::vector<Vec3> &points);

struct OutlineDemands
{
    double coverage;          // share of the way round that is drawn ...
    double longestGap;        // ... and what may be missing in one place
    double raggedness = 0.12; // how far it strays from its mean distance in a direction, share of that
};

struct Outline
{
    static constexpr int directions = 72;

    OutlinePlane plane;
    std::array<double, directions> radii; // from the middle; across gaps straight on to what is drawn next
    std::vector<Vec3> points;

    double radiusTowards(const Eigen::Vector2d &p) const;
    bool isInside(const Eigen::Vector2d &p, double share) const
    {
        return p.norm() < share * radiusTowards(p);
    }
};

/// Nothing where \a points do not go once round their middle.
std::optional<Outline> outlineThrough(const std::vector<Vec3> &points, const OutlineDemands &demands);

/// Evenly \a spacing apart between the outline's sides, as high as it is around them.
std::vector<Vec3> pointsInside(const Outline &outline, double spacing);

} // namespace ductus
