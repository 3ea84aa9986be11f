#include "doodling/tracking/motion_between.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr double mostOutside = 50.0; // pixels

} // namespace

std::optional<MotionAt> motionBetween(const Shot &shot, int from, int to, const Vec2 &pixel)
{
    if (to == from + 1)
        return shot.forward[std::size_t(from)].at(pixel);
    if (to == from - 1)
        return shot.backward[std::size_t(to)].at(pixel);
    const int first = std::min(from, to), gap = std::abs(to - from);
    const auto found = shot.longFlows.find({first, gap});
    if (found == shot.longFlows.end())
        return std::nullopt;
    return (from < to ? found->second.forward : found->second.backward).at(pixel);
}

std::vector<int> gapsOf(const Shot &shot)
{
    std::vector<int> gaps{1};
    for (int gap : longGaps)
        if (std::any_of(shot.longFlows.begin(), shot.longFlows.end(),
                        [&](const auto &flow) { return flow.first.second == gap; }))
            gaps.push_back(gap);
    return gaps;
}

Vec2 keptNear(const Shot &shot, const Vec2 &pixel)
{
    return {std::clamp(pixel.x(), -mostOutside, shot.width + mostOutside),
            std::clamp(pixel.y(), -mostOutside, shot.height + mostOutside)};
}

bool isInside(const Shot &shot, const Vec2 &pixel)
{
    return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < shot.width && pixel.y() < shot.height;
}

} // namespace ductus
