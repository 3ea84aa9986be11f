#include "support/stroke_hand.h"

#include "base/assert.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr double secondsPerPoint = 1.0 / 36.0; // a 72 Hz controller of which every other sample is kept

Vec3 normalVector(Random &random)
{
    // One by one: the order of evaluation of arguments is the compiler's.
    const double x = random.normal(), y = random.normal(), z = random.normal();
    return Vec3(x, y, z);
}

/// A slow three-dimensional wander with a root mean square length of 1: a constant, and two sine waves.
class Wander
{
public:
    Wander(double wobbleLength, Random &random)
    {
        mConstant = normalVector(random) * std::sqrt(0.4 / 3.0);
        for (Wave &wave : mWaves) {
            wave.direction = normalVector(random) * std::sqrt(0.6 / 3.0);
            wave.frequency = 2.0 * std::numbers::pi / (wobbleLength * random.uniform(0.6, 1.8));
            wave.phase = random.uniform(0.0, 2.0 * std::numbers::pi);
        }
    }

    Vec3 at(double s) const
    {
        Vec3 sum = mConstant;
        for (const Wave &wave : mWaves)
            sum += wave.direction * std::sin(wave.frequency * s + wave.phase);
        return sum;
    }

private:
    struct Wave
    {
        Vec3 direction;
        double frequency = 1.0;
        double phase = 0.0;
    };
    Vec3 mConstant;
    std::array<Wave, 2> mWaves;
};

} // namespace

ArcLengthCurve::ArcLengthCurve(std::vector<Vec3> points) : mPoints(std::move(points))
{
    DUCTUS_ASSERT(mPoints.size() >= 2);
    mAt.push_back(0.0);
    for (std::size_t i = 1; i < mPoints.size(); ++i)
        mAt.push_back(mAt.back() + (mPoints[i] - mPoints[i - 1]).norm());
    DUCTUS_ASSERT(mAt.back() > 0.0);
    mClosed = mPoints.size() > 2 && (mPoints.front() - mPoints.back()).norm() < 1e-9;
}

Vec3 ArcLengthCurve::at(double s) const
{
    if (mClosed)
        s -= length() * std::floor(s / length());
    const auto upper = std::upper_bound(mAt.begin() + 1, mAt.end() - 1, s);
    const std::size_t i = std::size_t(upper - mAt.begin());
    const double span = mAt[i] - mAt[i - 1];
    const double t = span > 0.0 ? (s - mAt[i - 1]) / span : 0.0;
    return mPoints[i - 1] + t * (mPoints[i] - mPoints[i - 1]);
}

double ArcLengthCurve::turning(double s, double reach) const
{
    const Vec3 before = at(s) - at(s - reach), after = at(s + reach) - at(s);
    return std::atan2(before.cross(after).norm(), before.dot(after));
}

Stroke drawStroke(const ArcLengthCurve &curve, double begin, double end, const HandOptions &options,
                  Random &random)
{
    DUCTUS_ASSERT(end > begin && options.step > 0.0);
    Stroke stroke;
    const Wander wander(options.wobbleLength, random);
    const auto add = [&](double s) {
        Vec3 shift = options.noise * wander.at(s) + options.offset;
        shift += normalVector(random) * (options.jitter / std::sqrt(3.0));
        if (options.plane)
            shift -= options.plane->normal.dot(shift) * options.plane->normal;
        stroke.points.push_back(curve.at(s) + shift);
        const double u = (s - begin) / (end - begin);
        stroke.pressure.push_back(0.35 + 0.5 * std::sqrt(std::max(0.0, std::sin(std::numbers::pi * u))));
        stroke.timeSeconds.push_back(double(stroke.timeSeconds.size()) * secondsPerPoint);
    };
    double s = begin;
    add(s);
    while (true) {
        // A hand speeds up, slows down, and turns corners slowly [minimum-jerk motion; two-thirds power law].
        const double u = (s - begin) / (end - begin);
        const double bell = 0.45 + 0.95 * std::sin(std::numbers::pi * std::clamp(u, 0.0, 1.0));
        const double corner = 1.0 / (1.0 + 1.2 * curve.turning(s, options.step));
        const double chance = random.uniform(0.6, 1.4);
        s += options.step * std::max(0.15, 1.0 + options.unevenness * (bell * corner * chance - 1.0));
        if (s >= end - 0.2 * options.step)
            break;
        add(s);
    }
    add(end);
    return stroke;
}

} // namespace ductus
