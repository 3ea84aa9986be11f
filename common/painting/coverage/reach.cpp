#include "painting/coverage/reach.h"

#include "base/parallel.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace ductus {

namespace {

constexpr int mostSamples = 256; // of a stroke

struct Sample
{
    double arc = 0; // along the stroke
    Vec3 across = Vec3::Zero();
};

Vec3 acrossNearest(const Vec3 &x, const std::vector<const LayerSolid *> &substrates)
{
    SegmentDistance nearest{std::numeric_limits<double>::infinity(), Vec3::Zero()};
    for (const LayerSolid *substrate : substrates) {
        const auto found = substrate->distance(x, std::max(0.0, nearest.distance));
        if (found && found->distance < nearest.distance)
            nearest = *found;
    }
    return nearest.direction;
}

/// The segments of one stroke.
class StrokeReach
{
public:
    StrokeReach(SegmentData *begin, SegmentData *end, double tolerance) : mBegin(begin), mEnd(end)
    {
        for (const SegmentData *segment = begin; segment != end; ++segment) {
            mRadius = std::max<double>({mRadius, segment->radiusA, segment->radiusB});
            mLength += (segment->b - segment->a).norm();
        }
        mSigma = 2 * std::max(mRadius, tolerance);
    }

    void set(const std::vector<const LayerSolid *> &substrates)
    {
        takeSamples(substrates);
        Vec3 last = Vec3::Zero();
        double arc = 0;
        for (SegmentData *segment = mBegin; segment != mEnd; ++segment) {
            segment->reachA = at(arc, *segment, last).cast<float>();
            arc += (segment->b - segment->a).norm();
            segment->reachB = at(arc, *segment, last).cast<float>();
        }
    }

private:
    void takeSamples(const std::vector<const LayerSolid *> &substrates)
    {
        const double step = std::max({0.5 * mRadius, mLength / mostSamples, 1e-12});
        double arc = 0, next = 0;
        for (const SegmentData *segment = mBegin; segment != mEnd; ++segment) {
            const double length = (segment->b - segment->a).norm();
            const Vec3 a = segment->a.cast<double>(), b = segment->b.cast<double>();
            for (; next <= arc + length; next += step) {
                const double t = length > 0 ? (next - arc) / length : 0;
                mSamples.push_back({next, acrossNearest((1 - t) * a + t * b, substrates)});
            }
            arc += length;
        }
    }

    Vec3 at(double arc, const SegmentData &segment, Vec3 &last) const
    {
        const auto begin = std::lower_bound(mSamples.begin(), mSamples.end(), arc - 3 * mSigma,
                                            [](const Sample &s, double value) { return s.arc < value; });
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        for (auto sample = begin; sample != mSamples.end() && sample->arc <= arc + 3 * mSigma; ++sample) {
            const double x = (sample->arc - arc) / mSigma;
            sum += std::exp(-0.5 * x * x) * sample->across * sample->across.transpose();
        }
        Vec3 direction;
        if (sum.trace() > 0) {
            direction = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(2);
        } else {
            const Vec3 axis = (segment.b - segment.a).cast<double>();
            direction = segment.kind() == StrokeSection::Ribbon
                            ? axis.cross(segment.u.cast<double>()).normalized()
                            : Vec3(segment.v.cast<double>());
        }
        if (direction.dot(last) < 0)
            direction = -direction;
        last = direction;
        return direction;
    }

    SegmentData *mBegin, *mEnd;
    double mRadius = 0, mLength = 0, mSigma = 0;
    std::vector<Sample> mSamples;
};

} // namespace

void setReach(LayerSolid &layer, const std::vector<const LayerSolid *> &substrates)
{
    std::vector<SegmentData> &segments = layer.segments();
    std::vector<std::size_t> starts; // of strokes
    for (std::size_t i = 0; i < segments.size(); ++i)
        if (i == 0 || segments[i].element != segments[i - 1].element)
            starts.push_back(i);
    starts.push_back(segments.size());
    parallelFor(0, starts.size() - 1, [&](std::size_t i) {
        StrokeReach(segments.data() + starts[i], segments.data() + starts[i + 1], layer.layer().tolerance)
            .set(substrates);
    });
}

} // namespace ductus
