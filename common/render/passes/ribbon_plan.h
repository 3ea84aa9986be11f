// Which strokes of the substrates are drawn as ribbons in a frame, and how many of them stand for all.
#pragma once

#include "render/passes/drawing_runs.h"

#include <map>

namespace ductus {

/// As glMultiDrawArraysIndirect reads it.
struct StripCommand
{
    std::uint32_t vertices = 0;
    std::uint32_t instances = 1;
    std::uint32_t firstVertex = 0;
    std::uint32_t firstInstance = 0; // of the widenings
};

struct RibbonPlan
{
    struct Layer
    {
        std::vector<bool> isDrawn; // each chunk
        std::vector<StripCommand> commands;
        std::vector<float> widenings; // the fewer are drawn the wider they are
        std::uint64_t vertices = 0;
    };
    std::map<LayerId, Layer> layers;

    const Layer *of(const DrawnLayer &layer) const;
};

/// Empty unless \a detail asks for ribbons and the painting is so large that they pay. Where the frame cannot
/// have them all, each chunk keeps its share of strokes: the same ones whenever its share is the same.
Result<RibbonPlan> planRibbons(PaintingUpload &painting, const ScreenFinder &screen, const Detail &detail);

} // namespace ductus
