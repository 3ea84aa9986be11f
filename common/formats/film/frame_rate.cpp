#include "formats/film/frame_rate.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double nearEnough = 1.0 / 2000.0; // half of what is between 30 and 29.97
constexpr double mostRounding = 0.0012;     // seconds

} // namespace

FrameRate frameRateNear(double framesPerSecond)
{
    const double whole = std::round(framesPerSecond);
    FrameRate best{0, 1};
    double least = nearEnough;
    const auto consider = [&](FrameRate rate) {
        const double difference = std::abs(rate.perSecond() / framesPerSecond - 1.0);
        if (difference < least) {
            least = difference;
            best = rate;
        }
    };
    if (whole >= 1.0)
        consider({int(whole), 1});
    for (int rate : {24, 30, 48, 60, 120, 240})
        consider({rate * 1000, 1001});
    if (best.numerator > 0)
        return best;
    least = 1e300;
    for (int denominator = 1; denominator <= 1001; ++denominator) {
        const double numerator = std::max(1.0, std::round(framesPerSecond * denominator));
        if (numerator < 1e9)
            consider({int(numerator), denominator});
        if (least < 1e-9)
            break;
    }
    return best;
}

std::optional<FrameRate> evenFrameRate(std::span<const double> times)
{
    if (times.size() < 2 || !(times.back() > times.front()))
        return std::nullopt;
    const FrameRate rate = frameRateNear(double(times.size() - 1) / (times.back() - times.front()));
    const double step = 1.0 / rate.perSecond();
    for (std::size_t i = 0; i < times.size(); ++i)
        if (std::abs(times[i] - times.front() - double(i) * step) > std::min(mostRounding, 0.25 * step))
            return std::nullopt;
    return rate;
}

} // namespace ductus
