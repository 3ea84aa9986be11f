#include "painting/coverage/segment_distance.h"

#include "geometry/triangle_point.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

SegmentDistance roundDistance(const SegmentData &segment, const Vec3 &x)
{
    const Vec3 a = segment.a.cast<double>(), axis = segment.b.cast<double>() - a, p = x - a;
    const double length = axis.norm(), ra = segment.radiusA, rb = segment.radiusB;
    double t = ra >= rb ? 0 : 1; // one ball in the other
    if (length > std::abs(ra - rb)) {
        // The ball of the hull whose skin is nearest stands where the mantle's normal points from.
        const Vec3 along = axis / length;
        const double y = p.dot(along), sine = (ra - rb) / length;
        const double rho = std::sqrt(std::max(0.0, p.squaredNorm() - y * y));
        t = std::clamp((y - rho * sine / std::sqrt(1 - sine * sine)) / length, 0.0, 1.0);
    }
    const Vec3 from = p - t * axis;
    const double distance = from.norm();
    return {distance - ((1 - t) * ra + t * rb), distance > 0 ? Vec3(from / distance) : Vec3(Vec3::Zero())};
}

SegmentDistance flatDistance(const SegmentData &segment, const Vec3 &x)
{
    const Vec3 a = segment.a.cast<double>(), axis = segment.b.cast<double>() - a;
    const Vec3 u = segment.u.cast<double>(), v = segment.v.cast<double>(), p = x - a;
    const double tau = std::clamp(p.dot(u.cross(v)) / axis.dot(u.cross(v)), 0.0, 1.0);
    const double r = (1 - tau) * segment.radiusA + tau * segment.radiusB;
    const double thick = segment.kind() == StrokeSection::Ellipse ? r * double(ellipseThickness) : r;
    const Vec3 q = p - tau * axis;
    const double pu = q.dot(u), pv = q.dot(v);
    const Vec3 outside = q - std::clamp(pu, -r, r) * u - std::clamp(pv, -thick, thick) * v;
    if (const double distance = outside.norm(); distance > 1e-9 * r)
        return {distance, outside / distance};
    return thick - std::abs(pv) <= r - std::abs(pu) ? SegmentDistance{std::abs(pv) - thick, v}
                                                    : SegmentDistance{std::abs(pu) - r, u};
}

SegmentDistance ribbonDistance(const SegmentData &segment, const Vec3 &x)
{
    const Vec3 a = segment.a.cast<double>(), b = segment.b.cast<double>();
    const Vec3 u = double(segment.radiusA) * segment.u.cast<double>();
    const Vec3 v = double(segment.radiusB) * segment.v.cast<double>();
    SegmentDistance nearest{1e300, Vec3::Zero()};
    for (const auto &[p, q, r] : {std::array<Vec3, 3>{a - u, a + u, b + v}, {a - u, b + v, b - v}}) {
        const Vec3 normal = (q - p).cross(r - p);
        if (normal.isZero())
            continue;
        const Vec3 w = nearestBarycentric(x, p, q, r);
        const Vec3 from = x - (w[0] * p + w[1] * q + w[2] * r);
        const double distance = from.norm();
        if (distance < nearest.distance) {
            const bool onIt = distance <= 1e-6 * (q - p).norm();
            nearest = {distance, onIt ? Vec3(normal.normalized()) : Vec3(from / distance)};
        }
    }
    return nearest;
}

} // namespace

SegmentDistance segmentDistance(const SegmentData &segment, const Vec3 &x)
{
    switch (segment.kind()) {
    case StrokeSection::Round:
        return roundDistance(segment, x);
    case StrokeSection::Ribbon:
        return ribbonDistance(segment, x);
    case StrokeSection::Ellipse:
    case StrokeSection::Cube:
        break;
    }
    return flatDistance(segment, x);
}

} // namespace ductus
