#include "doodling/tracking/motion_direction.h"

#include <algorithm>

namespace ductus {

namespace {

std::vector<double> speedsOf(const std::vector<Vec3> &trajectory)
{
    std::vector<double> speeds(trajectory.size(), 0.0);
    for (std::size_t t = 0; t + 1 < trajectory.size(); ++t)
        speeds[t] = (trajectory[t + 1] - trajectory[t]).norm();
    if (trajectory.size() > 1)
        speeds.back() = speeds[trajectory.size() - 2];
    return speeds;
}

double quantile(std::vector<double> values, double share)
{
    if (values.empty())
        return 0.0;
    const std::size_t at = std::min(values.size() - 1, std::size_t(share * double(values.size())));
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(at), values.end());
    return values[at];
}

} // namespace

MotionDirection motionDirections(const std::vector<Vec3> &trajectory, const OrientationOptions &options)
{
    const std::size_t frames = trajectory.size();
    MotionDirection motion{std::vector<Vec3>(frames, Vec3::Zero()), std::vector<double>(frames, 0.0),
                           std::vector<int>(frames, -1), 0};
    const std::vector<double> speeds = speedsOf(trajectory);
    const double fast = quantile(speeds, options.fastQuantile);
    if (fast < options.stillSpeed)
        return motion;
    for (std::size_t begin = 0; begin < frames;) {
        std::size_t end = begin;
        while (end < frames && speeds[end] >= options.turnSpeed * fast)
            ++end;
        if (end - begin >= std::size_t(options.shortestSegment)) {
            for (std::size_t t = begin; t < end; ++t) {
                // Not across the turns at the segment's ends.
                const std::size_t reach = std::size_t(options.smoothingFrames);
                const std::size_t from = t >= begin + reach ? t - reach : begin;
                const std::size_t to = std::min({t + reach, end, frames - 1});
                const Vec3 way = trajectory[to] - trajectory[from];
                if (way.norm() == 0.0)
                    continue;
                motion.directions[t] = way.normalized();
                motion.weights[t] = std::clamp(speeds[t] / fast, 0.0, 1.0);
                motion.segments[t] = motion.segmentCount;
            }
            ++motion.segmentCount;
        }
        begin = std::max(end, begin + 1);
    }
    return motion;
}

} // namespace ductus
