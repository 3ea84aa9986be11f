#include "surfacing/proxy/outline.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

using Vec2 = Eigen::Vector2d;
using Radii = std::array<double, Outline::directions>;

constexpr int directions = Outline::directions;

int directionOf(const Vec2 &p)
{
    const double turn = std::atan2(p.y(), p.x()) / (2.0 * std::numbers::pi) + 0.5;
    return std::clamp(int(turn * directions), 0, directions - 1);
}

Vec2 inDirection(double radius, int direction)
{
    const double a = 2.0 * std::numbers::pi * ((direction + 0.5) / directions - 0.5);
    return radius * Vec2(std::cos(a), std::sin(a));
}

std::size_t wrapped(int direction)
{
    return std::size_t((direction + directions) % directions);
}

// 0 in directions where nothing is drawn.
Radii meanRadii(const OutlinePlane &plane, const std::vector<Vec3> &points)
{
    Radii radii;
    radii.fill(0.0);
    std::array<int, directions> counts{};
    for (const Vec3 &p : points) {
        const Vec2 q = plane.across(p);
        const std::size_t d = std::size_t(directionOf(q));
        radii[d] += (q.norm() - radii[d]) / ++counts[d];
    }
    return radii;
}

int longestGap(const Radii &radii)
{
    int longest = 0, gap = 0;
    for (int turn = 0; turn < 2 * directions; ++turn) {
        gap = radii[wrapped(turn % directions)] > 0.0 ? 0 : gap + 1;
        longest = std::max(longest, gap);
    }
    return longest;
}

void closeGaps(Radii &radii)
{
    const Radii drawn = radii;
    for (int d = 0; d < directions; ++d) {
        if (drawn[std::size_t(d)] > 0.0)
            continue;
        int before = d, after = d;
        while (drawn[wrapped(before)] == 0.0)
            --before;
        while (drawn[wrapped(after)] == 0.0)
            ++after;
        const Vec2 from = inDirection(drawn[wrapped(before)], before),
                   to = inDirection(drawn[wrapped(after)], after);
        const Vec2 across(from.y() - to.y(), to.x() - from.x());
        radii[std::size_t(d)] = across.dot(from) / across.dot(inDirection(1.0, d));
    }
}

// Nearly all of it lies at one distance in each direction: no tangle of strokes that share a plane.
bool goesOnceRound(const Outline &outline, double raggedness)
{
    const auto ragged = std::count_if(outline.points.begin(), outline.points.end(), [&](const Vec3 &p) {
        const Vec2 q = outline.plane.across(p);
        const double radius = outline.radiusTowards(q);
        return std::abs(q.norm() - radius) > raggedness * radius;
    });
    return double(ragged) <= 0.1 * double(outline.points.size());
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

} // namespace

OutlinePlane planeThrough(const std::vector<Vec3> &points)
{
    OutlinePlane plane;
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

double Outline::radiusTowards(const Vec2 &p) const
{
    return radii[std::size_t(directionOf(p))];
}

std::optional<Outline> outlineThrough(const std::vector<Vec3> &points, const OutlineDemands &demands)
{
    Outline outline{planeThrough(points), {}, points};
    outline.radii = meanRadii(outline.plane, points);
    const auto drawn =
        std::count_if(outline.radii.begin(), outline.radii.end(), [](double r) { return r > 0.0; });
    if (double(drawn) < demands.coverage * directions ||
        longestGap(outline.radii) > demands.longestGap * directions ||
        !goesOnceRound(outline, demands.raggedness))
        return std::nullopt;
    closeGaps(outline.radii);
    return outline;
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

} // namespace ductus
