#include "doodling/canvas/doodle_time.h"

#include <algorithm>
#include <numeric>

namespace ductus {

namespace {

// The order frames are shown in during one cycle.
std::vector<int> order(const Doodle &doodle)
{
    std::vector<int> indices(doodle.frames.size());
    std::iota(indices.begin(), indices.end(), 0);
    if (doodle.repeat == DoodleRepeat::PingPong)
        for (int i = int(doodle.frames.size()) - 2; i > 0; --i)
            indices.push_back(i);
    return indices;
}

int holdOf(const Doodle &doodle, int index)
{
    return std::max(1, doodle.frames[std::size_t(index)].hold);
}

} // namespace

int cycleLength(const Doodle &doodle)
{
    int length = 0;
    for (int index : order(doodle))
        length += holdOf(doodle, index);
    return length;
}

std::optional<int> doodleFrameAt(const Doodle &doodle, int videoFrame)
{
    if (doodle.frames.empty())
        return std::nullopt;
    const int length = cycleLength(doodle);
    int time = videoFrame - doodle.offset;
    const bool isEndless = doodle.repeat == DoodleRepeat::Loop || doodle.repeat == DoodleRepeat::PingPong;
    if (isEndless)
        time = ((time % length) + length) % length;
    else if (time < 0)
        return std::nullopt;
    else if (time >= length)
        return doodle.repeat == DoodleRepeat::HoldLast ? std::optional(int(doodle.frames.size()) - 1)
                                                       : std::nullopt;
    for (int index : order(doodle)) {
        time -= holdOf(doodle, index);
        if (time < 0)
            return index;
    }
    return std::nullopt; // not reached: the holds add up to the length
}

std::optional<int> nextShowing(const Doodle &doodle, int index, int videoFrame)
{
    if (index < 0 || index >= int(doodle.frames.size()))
        return std::nullopt;
    const int last = std::max(videoFrame, doodle.offset) + cycleLength(doodle);
    for (int frame = videoFrame; frame <= last; ++frame)
        if (doodleFrameAt(doodle, frame) == index)
            return frame;
    return std::nullopt;
}

std::vector<OnionLayer> onionSkin(const Doodle &doodle, int index, int before, int after)
{
    const int count = int(doodle.frames.size());
    const bool isLoop = doodle.repeat == DoodleRepeat::Loop;
    std::vector<OnionLayer> layers;
    for (int distance = std::max(before, after); distance >= 1; --distance)
        for (const int sign : {-1, 1}) {
            if (distance > (sign < 0 ? before : after))
                continue;
            int neighbour = index + sign * distance;
            if (isLoop && distance < count)
                neighbour = (neighbour + count) % count;
            if (neighbour >= 0 && neighbour < count && neighbour != index)
                layers.push_back({neighbour, sign * distance, 0.4 / distance});
        }
    // Going round a short loop both ways meets the same frames: the shorter way counts.
    std::vector<OnionLayer> result;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const bool comesNearer = std::any_of(layers.begin() + std::ptrdiff_t(i) + 1, layers.end(),
                                             [&](const OnionLayer &l) { return l.index == layers[i].index; });
        if (!comesNearer)
            result.push_back(layers[i]);
    }
    return result;
}

} // namespace ductus
