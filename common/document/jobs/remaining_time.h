// RemainingTime: how long a job will still take, from how its progress went. Steady enough to be read: the
// speed is averaged over the last part of the way, and nothing is said before there is something to go by.
#pragma once

#include <optional>

namespace ductus {

class RemainingTime
{
public:
    /// Progress \a fraction (0..1) was reached \a seconds after the start.
    void note(double seconds, double fraction);

    /// Whole seconds left at \a seconds after the start; nothing in the first second, before 2 % of the work,
    /// or once there was no progress for so long that the average means nothing.
    std::optional<int> estimate(double seconds) const;

private:
    double mLastSeconds = 0.0;
    double mLastFraction = 0.0;
    double mSpeed = 0.0; // fraction a second, smoothed
};

} // namespace ductus
