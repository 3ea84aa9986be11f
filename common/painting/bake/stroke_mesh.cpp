#include "painting/bake/stroke_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

/// A section: the plane of a ring and its half axes.
struct Ring
{
    Vec3 centre, u, v;
    std::uint32_t segment;
};

class Skin
{
public:
    Skin(std::span<const SegmentData> stroke, double edge) : mStroke(stroke), mEdge(edge) {}

    SkinMesh run()
    {
        double radius = 0;
        for (const SegmentData &segment : mStroke)
            radius = std::max<double>({radius, segment.radiusA, segment.radiusB});
        const StrokeSection kind = mStroke.front().kind();
        if (kind == StrokeSection::Ribbon) {
            mOpen = true;
            const int across = steps(2 * radius, 1024);
            for (int k = 0; k <= across; ++k)
                mOutline.emplace_back(-1 + 2.0 * k / across, 0);
        } else if (kind == StrokeSection::Cube) {
            const int side = steps(2 * radius, 256);
            for (const auto &[x, y] : {std::pair{1, -1}, {1, 1}, {-1, 1}, {-1, -1}})
                for (int k = 0; k < side; ++k) {
                    const double t = 2.0 * k / side;
                    mOutline.emplace_back(x == y ? x - x * t : x, x == y ? y : y - y * t);
                }
        } else {
            const int sides = std::max(6, steps(2 * std::numbers::pi * radius, 96));
            for (int k = 0; k < sides; ++k)
                mOutline.emplace_back(std::cos(2 * std::numbers::pi * k / sides),
                                      std::sin(2 * std::numbers::pi * k / sides));
        }
        for (std::uint32_t i = 0; i < mStroke.size(); ++i)
            addSegment(i);
        return std::move(mMesh);
    }

private:
    int steps(double length, int most) const
    {
        return std::clamp(int(std::ceil(std::min(length / mEdge, 1e6) - 1e-9)), 1, most);
    }

    void addSegment(std::uint32_t i)
    {
        const SegmentData &s = mStroke[i];
        const Vec3 a = s.a.cast<double>(), b = s.b.cast<double>(), axis = b - a;
        const bool isFirst = i == 0 || mStroke[i - 1].b != s.a;
        const bool isLast = i + 1 == mStroke.size() || mStroke[i + 1].a != s.b;
        Vec3 along = axis.norm() > 0 ? Vec3(axis.normalized()) : Vec3(Vec3::UnitX());
        if (isFirst)
            mAcross = s.kind() == StrokeSection::Round ? along.unitOrthogonal() : s.u.cast<double>();
        if (isFirst && s.kind() == StrokeSection::Round)
            addBall(i, along, true);
        const int count = steps(axis.norm(), 4096);
        const int start = int(mMesh.vertices.size());
        for (int k = isFirst ? 0 : 1; k <= count; ++k)
            addRing(ringAt(i, double(k) / count), isFirst && k == 0);
        if (isFirst && !mOpen && s.kind() != StrokeSection::Round)
            addLid(start, true);
        if (isLast && s.kind() == StrokeSection::Round)
            addBall(i, along, false);
        else if (isLast && !mOpen)
            addLid(int(mMesh.vertices.size() - mOutline.size()), false);
    }

    /// The section at a parameter of a segment, in a plane between those of its ends.
    Ring ringAt(std::uint32_t i, double t)
    {
        const SegmentData &s = mStroke[i];
        const Vec3 a = s.a.cast<double>(), b = s.b.cast<double>();
        const double r = (1 - t) * s.radiusA + t * s.radiusB;
        Ring ring{(1 - t) * a + t * b, Vec3::Zero(), Vec3::Zero(), i};
        if (s.kind() == StrokeSection::Ribbon) {
            const Vec3 left = double(s.radiusA) * s.u.cast<double>(),
                       right = double(s.radiusB) * s.v.cast<double>();
            ring.u = (1 - t) * left + t * (left.dot(right) < 0 ? Vec3(-right) : right);
            return ring;
        }
        if (s.kind() == StrokeSection::Round) {
            const Vec3 axis = (b - a).norm() > 0 ? Vec3((b - a).normalized()) : Vec3(Vec3::UnitX());
            const Vec3 nA = s.clipA.isZero() ? axis : Vec3(s.clipA.cast<double>());
            const Vec3 nB = s.clipB.isZero() ? axis : Vec3(s.clipB.cast<double>());
            const Vec3 normal = ((1 - t) * nA + t * nB).normalized();
            const Vec3 rest = mAcross - mAcross.dot(normal) * normal; // carried along without turning
            mAcross = rest.norm() > 1e-6 ? Vec3(rest.normalized()) : normal.unitOrthogonal();
            ring.u = r * mAcross;
            ring.v = r * normal.cross(mAcross);
            return ring;
        }
        const Vec3 u = s.u.cast<double>(), v = s.v.cast<double>();
        // Half a turn gives the same section: keep to the side the last ring began on.
        const double sign = u.dot(mAcross) < 0 ? -1 : 1;
        mAcross = sign * u;
        ring.u = r * mAcross;
        ring.v = sign * r * (s.kind() == StrokeSection::Ellipse ? double(ellipseThickness) : 1.0) * v;
        return ring;
    }

    void addRing(const Ring &ring, bool alone)
    {
        const int count = int(mOutline.size()), start = int(mMesh.vertices.size());
        for (const Eigen::Vector2d &p : mOutline)
            mMesh.vertices.push_back({ring.centre + p.x() * ring.u + p.y() * ring.v, ring.segment});
        if (alone && !mJoinNext)
            return;
        mJoinNext = false;
        for (int k = 0; k + (mOpen ? 1 : 0) < count; ++k) {
            const int next = (k + 1) % count;
            const int p = start - count + k, q = start - count + next, r = start + k, s = start + next;
            mMesh.triangles.push_back({p, q, s});
            mMesh.triangles.push_back({p, s, r});
        }
    }

    /// Half a ball as rings, from its pole or to it.
    void addBall(std::uint32_t i, const Vec3 &along, bool atStart)
    {
        const SegmentData &s = mStroke[i];
        const Vec3 centre = (atStart ? s.a : s.b).cast<double>();
        const double r = atStart ? s.radiusA : s.radiusB;
        const Vec3 u = mAcross, v = along.cross(mAcross);
        const int count = std::clamp(steps(0.5 * std::numbers::pi * r, 24), 2, 24);
        if (r <= 0)
            return;
        // An end without a length has a whole ball: two halves.
        for (int k = 0; k <= count; ++k) {
            const double angle = 0.5 * std::numbers::pi * (atStart ? k : count - k) / count;
            const double radius = r * std::max(1e-9, std::sin(angle)), height = r * std::cos(angle);
            addRing({centre + (atStart ? -height : height) * along, radius * u, radius * v, i},
                    atStart && k == 0);
        }
        mJoinNext = atStart;
    }

    /// A fan over the ring that begins at \a start.
    void addLid(int start, bool atStart)
    {
        for (int k = 1; k + 1 < int(mOutline.size()); ++k) {
            if (atStart)
                mMesh.triangles.push_back({start, start + k + 1, start + k});
            else
                mMesh.triangles.push_back({start, start + k, start + k + 1});
        }
    }

    std::span<const SegmentData> mStroke;
    double mEdge;
    bool mOpen = false;
    bool mJoinNext = false; // the next first ring continues a half ball
    Vec3 mAcross = Vec3::UnitX();
    std::vector<Eigen::Vector2d> mOutline; // in half axes, counter-clockwise
    SkinMesh mMesh;
};

} // namespace

SkinMesh strokeMesh(std::span<const SegmentData> stroke, double edge)
{
    if (stroke.empty() || !(edge > 0))
        return {};
    return Skin(stroke, edge).run();
}

} // namespace ductus
