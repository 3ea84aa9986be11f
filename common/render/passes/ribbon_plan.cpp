#include "render/passes/ribbon_plan.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr std::uint32_t fewSegments = 20'000; // exact ones cost no more
constexpr double enoughPixels = 2;            // that a stroke covers; where it is less some stand for others
constexpr double widest = 2.5;

struct Wish
{
    LayerId layer;
    std::size_t number = 0; // of the chunk
    const RibbonChunk *chunk = nullptr;
    double share = 1; // of the chunk's strokes
};

} // namespace

const RibbonPlan::Layer *RibbonPlan::of(const DrawnLayer &layer) const
{
    const auto found = layers.find(layer.id);
    return found == layers.end() ? nullptr : &found->second;
}

Result<RibbonPlan> planRibbons(PaintingUpload &painting, const ScreenFinder &screen, const Detail &detail)
{
    RibbonPlan plan;
    if (detail.ribbonPixels <= 0 || detail.ribbonVertices <= 0)
        return plan;
    std::uint64_t segments = 0;
    for (const DrawnStack &stack : painting.stacks())
        for (const DrawnElement &element : stack.substrate.elements)
            segments += element.isMesh ? 0 : element.range.count;
    if (segments < fewSegments)
        return plan;
    if (Result<void> ready = painting.prepareRibbons(); !ready)
        return ready.error();

    std::vector<Wish> wishes;
    double wanted = 0;
    for (const DrawnStack &stack : painting.stacks()) {
        const std::vector<RibbonChunk> &chunks = painting.ribbons().chunksOf(stack.substrate);
        RibbonPlan::Layer layer;
        layer.isDrawn.assign(chunks.size(), false);
        for (std::size_t i = 0; i < chunks.size(); ++i) {
            const RibbonChunk &chunk = chunks[i];
            const bool isFar = screen.pixels(chunk.centre, chunk.radius, chunk.widest) <= detail.ribbonPixels;
            if (chunk.hasMeshes || chunk.ends.empty() || !isFar)
                continue;
            layer.isDrawn[i] = true;
            if (screen.rect(chunk.centre, chunk.radius).isEmpty())
                continue;
            const double perUnit = screen.pixels(chunk.centre, 0, 1);
            const double share = std::clamp(chunk.meanArea * perUnit * perUnit / enoughPixels, 0.02, 1.0);
            wishes.push_back({stack.substrate.id, i, &chunk, share});
            wanted += share * chunk.ends.back();
        }
        plan.layers.emplace(stack.substrate.id, std::move(layer));
    }
    const double given = std::min(1.0, detail.ribbonVertices / std::max(wanted, 1.0));
    for (const Wish &wish : wishes) {
        RibbonPlan::Layer &layer = plan.layers.at(wish.layer);
        const double all = double(wish.chunk->ends.size());
        const auto count = std::size_t(std::clamp(std::ceil(wish.share * given * all), 1.0, all));
        const std::uint32_t vertices = wish.chunk->ends[count - 1];
        if (vertices == 0)
            continue;
        layer.commands.push_back(
            {vertices, 1, wish.chunk->vertices.first, std::uint32_t(layer.widenings.size())});
        layer.widenings.push_back(float(std::min(widest, all / double(count))));
        layer.vertices += vertices;
    }
    return plan;
}

} // namespace ductus
