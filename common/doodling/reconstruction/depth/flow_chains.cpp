#include "doodling/reconstruction/depth/flow_chains.h"

#include <algorithm>
#include <cmath>

namespace ductus {

std::vector<ChainedPlaces> chainedFrom(const Shot &shot, int frame, int steps, const ChainOptions &options)
{
    std::vector<ChainedPlaces> kept;
    if (shot.forward.empty() || steps == 0)
        return kept;
    const CompactFlow &grid = shot.forward.front();
    ChainedPlaces places;
    places.frame = frame;
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) {
            places.pixels.emplace_back(float((x + 0.5) * grid.cellSize), float((y + 0.5) * grid.cellSize));
            places.trusts.push_back(1.0f);
        }
    const int direction = steps > 0 ? 1 : -1;
    for (int step = 1; step <= std::abs(steps); ++step) {
        const int from = places.frame, to = from + direction;
        if (to < 0 || to >= shot.frameCount())
            break;
        const CompactFlow &flow =
            direction > 0 ? shot.forward[std::size_t(from)] : shot.backward[std::size_t(to)];
        for (std::size_t i = 0; i < places.pixels.size(); ++i) {
            if (places.trusts[i] <= 0.0f)
                continue;
            const Vec2 pixel = places.pixels[i].cast<double>();
            const MotionAt step = flow.at(pixel);
            const float confidence = float(step.confidence);
            if (confidence < options.leastConfidence) {
                places.trusts[i] = 0.0f;
                continue;
            }
            places.trusts[i] = std::min(places.trusts[i], confidence);
            places.pixels[i] += step.motion.cast<float>();
        }
        places.frame = to;
        if (step % options.everyFrame == 0)
            kept.push_back(places);
    }
    return kept;
}

} // namespace ductus
