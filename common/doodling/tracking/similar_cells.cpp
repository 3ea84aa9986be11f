#include "doodling/tracking/similar_cells.h"

#include <algorithm>

namespace ductus {

namespace {

struct Sample
{
    const FeatureGrid *grid;
    int cell;
};

} // namespace

std::vector<std::vector<int>> similarCells(const Shot &shot, const std::vector<CanvasKeyframe> &keyframes,
                                           double share)
{
    std::vector<Sample> samples;
    for (const CanvasKeyframe &key : keyframes) {
        const FeatureGrid &grid = shot.features[std::size_t(key.frame)];
        samples.push_back({&grid, grid.cellAt(key.pixel.x(), key.pixel.y())});
    }
    std::vector<std::vector<int>> cells(std::size_t(shot.frameCount()));
    std::size_t next = 0; // the first keyframe at or after the frame
    for (int t = 0; t < shot.frameCount(); ++t) {
        while (next < keyframes.size() && keyframes[next].frame < t)
            ++next;
        const FeatureGrid &grid = shot.features[std::size_t(t)];
        if (next < keyframes.size() && keyframes[next].frame == t) {
            cells[std::size_t(t)] = {samples[next].cell};
            continue;
        }
        std::vector<std::pair<double, int>> ranked;
        for (int cell = 0; cell < grid.width * grid.height; ++cell) {
            double least = 1e300;
            for (std::size_t k = next > 0 ? next - 1 : 0; k <= next && k < samples.size(); ++k)
                least = std::min(least, grid.distance(cell, *samples[k].grid, samples[k].cell));
            ranked.emplace_back(least, cell);
        }
        const std::size_t kept =
            std::clamp<std::size_t>(std::size_t(share * double(ranked.size())), 1, ranked.size());
        std::nth_element(ranked.begin(), ranked.begin() + std::ptrdiff_t(kept - 1), ranked.end());
        for (std::size_t i = 0; i < kept; ++i)
            cells[std::size_t(t)].push_back(ranked[i].second);
        std::sort(cells[std::size_t(t)].begin(), cells[std::size_t(t)].end());
    }
    return cells;
}

} // namespace ductus
