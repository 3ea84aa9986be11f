// The hand that draws: one stroke along a part of a curve, with its tremor, misplacement and speed.
#pragma once

#include "base/random.h"
#include "strokes/stroke.h"
#include "support/solids.h"

namespace ductus {

/// A polyline by arc length; closed ones continue round, open ones straight on beyond their ends.
class ArcLengthCurve
{
public:
    explicit ArcLengthCurve(std::vector<Vec3> points);

    double length() const { return mAt.back(); }
    bool isClosed() const { return mClosed; }
    const std::vector<Vec3> &points() const { return mPoints; }
    /// Arc length of point number \a index.
    double parameter(std::size_t index) const { return mAt[index]; }
    Vec3 at(double s) const;
    /// Turning (radians) between s - reach and s + reach.
    double turning(double s, double reach) const;

private:
    std::vector<Vec3> mPoints;
    std::vector<double> mAt;
    bool mClosed = false;
};

/// Lengths in the curve's unit.
struct HandOptions
{
    double noise = 0.0;  // root mean square displacement without jitter
    double jitter = 0.0; // root mean square displacement point by point
    Vec3 offset = Vec3::Zero();
    double wobbleLength = 1.0; // the slow part of the noise goes round once in about this length
    double step = 0.01;
    double unevenness = 0.6;
    const MirrorPlane *plane = nullptr; // the stroke stays in it
};

/// The stroke from arc length \a begin to \a end; id and role are the caller's.
Stroke drawStroke(const ArcLengthCurve &curve, double begin, double end, const HandOptions &options,
                  Random &random);

} // namespace ductus
