#include "render/passes/drawing_runs.h"

#include <vector>

namespace ductus {

namespace {

constexpr std::uint32_t roundOnly = 1u << unsigned(StrokeSection::Round);

/// Elements that are drawn alike, so that changes between them stay rare: each costs a draw.
constexpr std::size_t chunk = RibbonChunks::strokesPerChunk;

/// Whether all strokes of a chunk are so far away that those with fewer points serve.
std::vector<bool> chunksThatMayBeCoarse(const DrawnLayer &layer, const ScreenFinder &screen,
                                        double errorPixels)
{
    std::vector<bool> may(layer.elements.size() / chunk + 1, errorPixels > 0);
    for (std::size_t i = 0; i < layer.elements.size(); ++i) {
        const DrawnElement &element = layer.elements[i];
        if (may[i / chunk] && element.coarse.count > 0 &&
            screen.pixels(element.centre, element.radius, element.coarseError) >= errorPixels)
            may[i / chunk] = false;
    }
    return may;
}

} // namespace

LayerInView layerInView(const DrawnLayer &layer, const ScreenFinder &screen, const Detail &detail,
                        const ElementsWanted &wanted)
{
    LayerInView view;
    const std::vector<bool> coarseChunks = wanted.mayBeCoarse
                                               ? chunksThatMayBeCoarse(layer, screen, detail.errorPixels)
                                               : std::vector<bool>(layer.elements.size() / chunk + 1);
    for (std::size_t step = 0; step < layer.elements.size(); ++step) {
        const std::size_t at = wanted.isBackwards ? layer.elements.size() - 1 - step : step;
        if (wanted.skipped && (*wanted.skipped)[at / chunk])
            continue;
        const DrawnElement &element = layer.elements[at];
        const double radius = element.radius + wanted.margin;
        const PixelRect rect = screen.rect(element.centre, radius);
        if (rect.isEmpty() || screen.pixels(element.centre, radius, 2 * radius) < detail.smallestPixels)
            continue;
        view.rect = view.rect.with(rect);
        if (element.isMesh) {
            view.runs.push_back({&element, false, 0, 0, rect});
            continue;
        }
        const bool coarse = coarseChunks[at / chunk] && element.coarse.count > 0;
        const CardRange &range = coarse ? element.coarse : element.range;
        if (view.runs.empty() || view.runs.back().mesh || view.runs.back().coarse != coarse)
            view.runs.push_back({nullptr, coarse, std::uint32_t(view.commands.size()), 0, {}});
        DrawingRun &run = view.runs.back();
        run.rect = run.rect.with(rect);
        view.segments += range.count;
        DrawCommand *last = run.commandCount > 0 ? &view.commands.back() : nullptr;
        const bool asCards = layer.sections == roundOnly && screen.isFar(element.centre, radius);
        const std::uint32_t firstIndex = asCards ? boxIndexCount : 0;
        if (last && !wanted.isBackwards && last->firstInstance + last->instances == range.first &&
            last->firstIndex == firstIndex) {
            last->instances += range.count;
        } else {
            view.commands.push_back(
                {asCards ? cardIndexCount : boxIndexCount, range.count, firstIndex, 0, range.first});
            ++run.commandCount;
        }
    }
    return view;
}

} // namespace ductus
