#include "document/jobs/remaining_time.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double silentSeconds = 1.0;
constexpr double silentFraction = 0.02;
constexpr double memorySeconds = 8.0; // older speeds count for less than 1/e
constexpr double stepSeconds = 0.2;   // shorter steps are noise

} // namespace

void RemainingTime::note(double seconds, double fraction)
{
    if (fraction < mLastFraction) {
        *this = RemainingTime(); // the work started over
        mLastSeconds = seconds;
        mLastFraction = fraction;
        return;
    }
    const double step = seconds - mLastSeconds;
    if (step < stepSeconds || fraction <= mLastFraction)
        return;
    const double speed = (fraction - mLastFraction) / step;
    const double weight = mSpeed == 0.0 ? 1.0 : 1.0 - std::exp(-step / memorySeconds);
    mSpeed += weight * (speed - mSpeed);
    mLastSeconds = seconds;
    mLastFraction = fraction;
}

std::optional<int> RemainingTime::estimate(double seconds) const
{
    if (seconds < silentSeconds || mLastFraction < silentFraction || mSpeed <= 0.0)
        return std::nullopt;
    const double still = seconds - mLastSeconds;
    const double left = (1.0 - mLastFraction) / mSpeed - still;
    if (left < -0.5 * still && still > memorySeconds)
        return std::nullopt;
    return std::max(0, int(std::ceil(left)));
}

} // namespace ductus
