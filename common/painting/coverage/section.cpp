#include "painting/coverage/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ductus {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Interval empty{infinity, -infinity};
constexpr Interval everywhere{-infinity, infinity};

Interval both(const Interval &one, const Interval &other)
{
    return {std::max(one.first, other.first), std::min(one.second, other.second)};
}

/// Where c + s * slope >= 0.
Interval halfSpace(double c, double slope)
{
    if (slope > 0)
        return {-c / slope, infinity};
    if (slope < 0)
        return {-infinity, -c / slope};
    return c >= 0 ? everywhere : empty;
}

/// The roots of qa s^2 + 2 qb s + qc in order, without cancellation; none if there are none.
std::optional<Interval> roots(double qa, double qb, double qc)
{
    const double discriminant = qb * qb - qa * qc;
    if (discriminant < 0)
        return std::nullopt;
    const double q = -(qb + std::copysign(std::sqrt(discriminant), qb));
    if (q == 0)
        return Interval{0, 0};
    const double s0 = qc / q, s1 = qa == 0 ? std::copysign(infinity, q) : q / qa;
    return Interval{std::min(s0, s1), std::max(s0, s1)};
}

/// A segment in double numbers, with what all tests need.
struct Solid
{
    explicit Solid(const SegmentData &data)
        : kind(data.kind()), a(data.a.cast<double>()), b(data.b.cast<double>()), radiusA(data.radiusA),
          radiusB(data.radiusB), nA(data.clipA.cast<double>()), nB(data.clipB.cast<double>()),
          slack(double(seamSlack) * std::max(radiusA, radiusB))
    {
    }

    bool keeps(const Vec3 &x) const { return keepsA(x) && keepsB(x); }
    bool keepsA(const Vec3 &x) const { return (x - a).dot(nA) >= -slack; }
    bool keepsB(const Vec3 &x) const { return (x - b).dot(nB) <= slack; }

    Interval clip(const Vec3 &origin, const Vec3 &direction) const
    {
        return both(halfSpace((origin - a).dot(nA) + slack, direction.dot(nA)),
                    halfSpace(slack - (origin - b).dot(nB), -direction.dot(nB)));
    }

    StrokeSection kind;
    Vec3 a, b;
    double radiusA, radiusB;
    Vec3 nA, nB;
    double slack;
};

/// The convex hull of two balls: its mantle is  cos^2 |p|^2 - y^2 + 2 rA sin y - rA^2 = 0  for rA sin <= y <=
/// L + rB sin, where p = x - a, y is p along the axis and sin = (rA - rB) / L.
struct RoundBody
{
    explicit RoundBody(const Solid &s) : solid(s), axis(s.b - s.a), length(axis.norm())
    {
        hasMantle = length > std::abs(s.radiusA - s.radiusB);
        if (!hasMantle)
            return;
        axis /= length;
        sine = (s.radiusA - s.radiusB) / length;
        cosine2 = 1 - sine * sine;
    }

    bool isBetween(double y) const { return y >= solid.radiusA * sine && y <= length + solid.radiusB * sine; }

    bool contains(const Vec3 &x) const
    {
        const Vec3 p = x - solid.a;
        if (p.squaredNorm() <= solid.radiusA * solid.radiusA ||
            (x - solid.b).squaredNorm() <= solid.radiusB * solid.radiusB)
            return true;
        if (!hasMantle)
            return false;
        const double y = p.dot(axis), toMantle = solid.radiusA - y * sine;
        return isBetween(y) && cosine2 * (p.squaredNorm() - y * y) <= toMantle * toMantle;
    }

    Interval interval(const Vec3 &origin, const Vec3 &direction) const
    {
        // From the line's point nearest to the middle: otherwise thin strokes far away drown in rounding.
        const double dd = direction.squaredNorm();
        const double shift = (0.5 * (solid.a + solid.b) - origin).dot(direction) / dd;
        const Vec3 p = origin + shift * direction - solid.a, q = p + solid.a - solid.b;
        Interval hits = empty;
        const auto add = [&](double s) {
            hits.first = std::min(hits.first, s);
            hits.second = std::max(hits.second, s);
        };
        const auto addBall = [&](const Vec3 &from, double radius) {
            if (const auto ball = roots(dd, from.dot(direction), from.squaredNorm() - radius * radius)) {
                add(ball->first);
                add(ball->second);
            }
        };
        addBall(p, solid.radiusA);
        addBall(q, solid.radiusB);
        if (hasMantle) {
            const double y = p.dot(axis), slope = direction.dot(axis), ra = solid.radiusA;
            if (const auto mantle = roots(cosine2 * dd - slope * slope,
                                          cosine2 * p.dot(direction) - y * slope + ra * sine * slope,
                                          cosine2 * p.squaredNorm() - y * y + 2 * ra * sine * y - ra * ra))
                for (const double s : {mantle->first, mantle->second})
                    if (std::isfinite(s) && isBetween(y + s * slope))
                        add(s);
        }
        return {hits.first + shift, hits.second + shift};
    }

    const Solid &solid;
    Vec3 axis;
    double length;
    bool hasMantle = false;
    double sine = 0, cosine2 = 1;
};

/// Elliptic cone or pyramid along an axis that may be oblique to its sections.
struct FlatBody
{
    FlatBody(const Solid &s, const SegmentData &data)
        : solid(s), widest(std::max(s.radiusA, s.radiusB)), growth(s.radiusB - s.radiusA),
          thickness(s.kind == StrokeSection::Ellipse ? double(ellipseThickness) : 1.0)
    {
        const Vec3 axis = s.b - s.a, u = data.u.cast<double>(), v = data.v.cast<double>();
        const double det = axis.dot(u.cross(v));
        rows.row(0) = u.cross(v) / det;
        rows.row(1) = v.cross(axis) / det;
        rows.row(2) = axis.cross(u) / (det * thickness);
    }

    /// (tau, u, v / thickness)
    Vec3 local(const Vec3 &x) const { return rows * (x - solid.a); }

    bool contains(const Vec3 &x) const
    {
        const Vec3 p = local(x);
        const double r = std::min(solid.radiusA + p[0] * growth, widest);
        if (solid.kind == StrokeSection::Cube)
            return std::max(std::abs(p[1]), std::abs(p[2])) <= r;
        return r >= 0 && p[1] * p[1] + p[2] * p[2] <= r * r;
    }

    Interval interval(const Vec3 &origin, const Vec3 &direction) const
    {
        const double shift = (0.5 * (solid.a + solid.b) - origin).dot(direction) / direction.squaredNorm();
        const Vec3 p = local(origin + shift * direction), d = rows * direction;
        const Interval hits =
            solid.kind == StrokeSection::Cube ? pyramid(p, d) : both(cone(p, d), cylinder(p, d));
        return {hits.first + shift, hits.second + shift};
    }

private:
    Interval pyramid(const Vec3 &p, const Vec3 &d) const
    {
        Interval hits = everywhere;
        for (const int i : {1, 2})
            for (const double side : {-1.0, 1.0}) {
                hits = both(hits, halfSpace(solid.radiusA + p[0] * growth + side * p[i],
                                            d[0] * growth + side * d[i]));
                hits = both(hits, halfSpace(widest + side * p[i], side * d[i]));
            }
        return hits;
    }

    Interval cylinder(const Vec3 &p, const Vec3 &d) const
    {
        const double qa = d[1] * d[1] + d[2] * d[2];
        const double qc = p[1] * p[1] + p[2] * p[2] - widest * widest;
        if (qa == 0)
            return qc <= 0 ? everywhere : empty;
        return roots(qa, p[1] * d[1] + p[2] * d[2], qc).value_or(empty);
    }

    /// u^2 + v^2 <= r^2 on the side where r >= 0.
    Interval cone(const Vec3 &p, const Vec3 &d) const
    {
        if (growth == 0)
            return everywhere; // the cylinder says it all
        const double r = solid.radiusA + p[0] * growth, slope = d[0] * growth;
        const double qa = d[1] * d[1] + d[2] * d[2] - slope * slope;
        const auto hits = roots(qa, p[1] * d[1] + p[2] * d[2] - r * slope, p[1] * p[1] + p[2] * p[2] - r * r);
        if (!hits)
            return empty;
        if (qa > 0) {
            const double middle = 0.5 * (hits->first + hits->second);
            return r + middle * slope >= 0 ? *hits : empty;
        }
        // The line runs steeper than the mantle: it enters and stays, in the direction in which r grows.
        if (slope > 0)
            return {hits->second, infinity};
        return slope < 0 ? Interval{-infinity, hits->first} : empty;
    }

    const Solid &solid;
    double widest, growth, thickness;
    Eigen::Matrix3d rows;
};

std::optional<double> hitTriangle(const std::array<Vec3, 3> &t, const Vec3 &origin, const Vec3 &direction)
{
    const Vec3 e1 = t[1] - t[0], e2 = t[2] - t[0], cross = direction.cross(e2); // [Moeller, Trumbore 1997]
    const double det = e1.dot(cross);
    if (det == 0)
        return std::nullopt;
    const Vec3 from = origin - t[0];
    const double u = from.dot(cross) / det;
    const Vec3 other = from.cross(e1);
    const double v = direction.dot(other) / det;
    constexpr double edge = -1e-9; // no pinholes between the two
    if (u < edge || v < edge || u + v > 1 - edge)
        return std::nullopt;
    return e2.dot(other) / det;
}

std::optional<double> hitRibbon(const SegmentData &segment, const Vec3 &origin, const Vec3 &direction)
{
    const Vec3 a = segment.a.cast<double>(), b = segment.b.cast<double>();
    const Vec3 u = double(segment.radiusA) * segment.u.cast<double>();
    const Vec3 v = double(segment.radiusB) * segment.v.cast<double>();
    if (const auto s = hitTriangle({a - u, a + u, b + v}, origin, direction))
        return s;
    return hitTriangle({a - u, b + v, b - v}, origin, direction);
}

/// The body without the planes.
Interval bodyInterval(const SegmentData &segment, const Solid &solid, const Vec3 &origin,
                      const Vec3 &direction)
{
    if (solid.kind == StrokeSection::Round)
        return RoundBody(solid).interval(origin, direction);
    return FlatBody(solid, segment).interval(origin, direction);
}

SegmentBounds boxAround(const std::vector<Vec3> &points, const Vec3 &x, const Vec3 &y, double margin)
{
    const std::array<Vec3, 3> axes{x, y, x.cross(y)};
    SegmentBounds bounds;
    bounds.centre = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        double low = infinity, high = -infinity;
        for (const Vec3 &point : points) {
            low = std::min(low, point.dot(axes[i]));
            high = std::max(high, point.dot(axes[i]));
        }
        bounds.centre += 0.5 * (low + high) * axes[i];
        bounds.halfAxes[i] = (0.5 * (high - low) + margin) * axes[i];
    }
    return bounds;
}

} // namespace

double segmentParameter(const SegmentData &segment, const Vec3 &x)
{
    const Vec3 a = segment.a.cast<double>(), b = segment.b.cast<double>(), p = x - a;
    const double length = (b - a).norm();
    double y = 0;
    if (segment.clipA.isZero() || segment.clipB.isZero()) {
        const double ra = segment.radiusA, rb = segment.radiusB;
        const Vec3 axis = (b - a).normalized(); // zero stays zero
        y = p.dot(axis);
        if (segment.kind() == StrokeSection::Round) {
            const double sine = (ra - rb) / length;
            const double rho = std::sqrt(std::max(0.0, p.squaredNorm() - y * y));
            if (length > std::abs(ra - rb))
                y -= rho * sine / std::sqrt(1 - sine * sine);
            else
                y = ra >= rb ? 0 : length;
        }
    }
    const double fA = segment.clipA.isZero() ? y : p.dot(segment.clipA.cast<double>());
    const double fB = segment.clipB.isZero() ? y - length : (x - b).dot(segment.clipB.cast<double>());
    return fA - fB > 0 ? std::clamp(fA / (fA - fB), 0.0, 1.0) : 0.5;
}

bool segmentContains(const SegmentData &segment, const Vec3 &x)
{
    const Solid solid(segment);
    switch (solid.kind) {
    case StrokeSection::Ribbon:
        return false;
    case StrokeSection::Round:
        return solid.keeps(x) && RoundBody(solid).contains(x);
    case StrokeSection::Ellipse:
    case StrokeSection::Cube:
        break;
    }
    return solid.keeps(x) && FlatBody(solid, segment).contains(x);
}

std::optional<Interval> segmentInterval(const SegmentData &segment, const Vec3 &origin, const Vec3 &direction)
{
    if (direction.isZero())
        return std::nullopt;
    if (segment.kind() == StrokeSection::Ribbon) {
        const auto s = hitRibbon(segment, origin, direction);
        return s ? std::optional(Interval{*s, *s}) : std::nullopt;
    }
    const Solid solid(segment);
    const Interval hits =
        both(bodyInterval(segment, solid, origin, direction), solid.clip(origin, direction));
    return hits.first <= hits.second ? std::optional(hits) : std::nullopt;
}

std::optional<double> segmentSurface(const SegmentData &segment, const Vec3 &origin, const Vec3 &direction,
                                     double from)
{
    if (segment.kind() == StrokeSection::Ribbon) {
        const auto s = hitRibbon(segment, origin, direction);
        return s && *s >= from ? s : std::nullopt;
    }
    const Solid solid(segment);
    const Interval body = bodyInterval(segment, solid, origin, direction);
    if (!(body.first <= body.second))
        return std::nullopt;
    std::optional<double> nearest;
    const auto offer = [&](double s) {
        if (s >= from && (!nearest || s < *nearest))
            nearest = s;
    };
    for (const double s : {body.first, body.second})
        if (std::isfinite(s) && solid.keeps(origin + s * direction))
            offer(s);
    const auto offerCap = [&](const Vec3 &through, const Vec3 &normal, bool atA) {
        const double slope = direction.dot(normal);
        if (slope == 0)
            return;
        const double s = (through - origin).dot(normal) / slope;
        const Vec3 x = origin + s * direction;
        if (s >= body.first && s <= body.second && (atA ? solid.keepsB(x) : solid.keepsA(x)))
            offer(s);
    };
    if (segment.caps & SegmentData::capAtA)
        offerCap(solid.a, solid.nA, true);
    if (segment.caps & SegmentData::capAtB)
        offerCap(solid.b, solid.nB, false);
    return nearest;
}

Vec3 segmentReach(const SegmentData &segment, const Vec3 &x)
{
    const double t = segmentParameter(segment, x);
    return ((1 - t) * segment.reachA.cast<double>() + t * segment.reachB.cast<double>()).normalized();
}

bool segmentReaches(const SegmentData &segment, const Vec3 &x, double tolerance)
{
    if (segmentContains(segment, x))
        return true;
    if (!(tolerance > 0))
        return false;
    const auto hits = segmentInterval(segment, x, segmentReach(segment, x));
    return hits && hits->first <= tolerance && hits->second >= -tolerance;
}

SegmentBounds segmentBounds(const SegmentData &segment, double tolerance)
{
    const Solid solid(segment);
    const double radius = std::max(solid.radiusA, solid.radiusB);
    const double margin = tolerance + 2 * solid.slack;
    const Vec3 axis = solid.b - solid.a, u = segment.u.cast<double>(), v = segment.v.cast<double>();
    if (solid.kind == StrokeSection::Round) {
        const Vec3 along = axis.norm() > 0 ? Vec3(axis.normalized()) : Vec3(Vec3::UnitX());
        return boxAround({solid.a, solid.b}, along, along.unitOrthogonal(), radius + margin);
    }
    if (solid.kind == StrokeSection::Ribbon) {
        const Vec3 left = solid.radiusA * u, right = solid.radiusB * v;
        const Vec3 across = u.dot(v) >= 0 ? Vec3((u + v).normalized()) : u;
        const Vec3 rest = axis - axis.dot(across) * across;
        const Vec3 along = rest.norm() > 0 ? Vec3(rest.normalized()) : across.unitOrthogonal();
        return boxAround({solid.a - left, solid.a + left, solid.b - right, solid.b + right}, across, along,
                         margin);
    }
    const double thick = solid.kind == StrokeSection::Ellipse ? radius * double(ellipseThickness) : radius;
    const auto beyond = [&](const Vec3 &normal) { // how far, in tau, an oblique end sticks out
        return (radius * std::abs(u.dot(normal)) + thick * std::abs(v.dot(normal)) + solid.slack) /
               axis.dot(normal);
    };
    std::vector<Vec3> corners;
    for (const double tau : {-beyond(solid.nA), 1 + beyond(solid.nB)})
        for (const double x : {-radius, radius})
            for (const double y : {-thick, thick})
                corners.push_back(solid.a + tau * axis + x * u + y * v);
    return boxAround(corners, u, v, margin);
}

Box3 SegmentBounds::box() const
{
    Vec3 half = Vec3::Zero();
    for (const Vec3 &axis : halfAxes)
        half += axis.cwiseAbs();
    Box3 box;
    box.add(centre - half);
    box.add(centre + half);
    return box;
}

} // namespace ductus
