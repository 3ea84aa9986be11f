// Frame rates as the fractions they are: 30000/1001 and not 29.97.
#pragma once

#include <optional>
#include <span>

namespace ductus {

struct FrameRate
{
    int numerator = 25, denominator = 1;

    double perSecond() const { return double(numerator) / denominator; }
    bool operator==(const FrameRate &) const = default;
};

/// The rate films are made with that is nearest to \a framesPerSecond (> 0): a whole number or one of the
/// n * 1000/1001 of television within 1/2000 of it, else the best fraction with a denominator up to 1001.
FrameRate frameRateNear(double framesPerSecond);

/// The rate at which frames come at \a times (seconds from the first one), if the steps are even but for the
/// rounding to milliseconds some containers do. None for less than two frames.
std::optional<FrameRate> evenFrameRate(std::span<const double> times);

} // namespace ductus
