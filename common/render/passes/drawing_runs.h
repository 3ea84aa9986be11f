// What of a layer is in view, as few draws as the order allows.
#pragma once

#include "render/passes/pixel_rect.h"
#include "render/upload/painting_upload.h"

#include <array>

namespace ductus {

/// As glMultiDrawElementsIndirect reads it.
struct DrawCommand
{
    std::uint32_t indices = boxIndexCount;
    std::uint32_t instances = 0;
    std::uint32_t firstIndex = 0; // boxIndexCount for cards
    std::int32_t baseVertex = 0;
    std::uint32_t firstInstance = 0;
};

/// Strokes that are drawn by one call, or one mesh.
struct DrawingRun
{
    const DrawnElement *mesh = nullptr;
    bool coarse = false; // from the segments with fewer points
    std::uint32_t firstCommand = 0, commandCount = 0;
    PixelRect rect;
};

struct LayerInView
{
    std::vector<DrawingRun> runs;
    std::vector<DrawCommand> commands;
    PixelRect rect;
    std::uint64_t segments = 0;
};

/// What is small may be drawn with less.
struct Detail
{
    double smallestPixels = 0; // what is smaller across is left out
    double errorPixels = 0;    // strokes may be this much off
    double ribbonPixels = 0;   // shapes' strokes of no more half width may be ribbons
    int ribbonVertices = 0;    // of a frame, at most
};

struct ElementsWanted
{
    double margin = 0;        // by how much elements reach beyond themselves, scene units
    bool mayBeCoarse = false; // strokes with fewer points serve as well
    bool isBackwards = false; // from the last to the first
    /// Of each RibbonChunks::strokesPerChunk elements whether they are drawn otherwise; null: none are.
    const std::vector<bool> *skipped = nullptr;
};

LayerInView layerInView(const DrawnLayer &layer, const ScreenFinder &screen, const Detail &detail,
                        const ElementsWanted &wanted);

} // namespace ductus
