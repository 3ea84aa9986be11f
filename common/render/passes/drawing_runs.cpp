#include "render/passes/drawing_runs.h"

namespace ductus {

LayerInView layerInView(const DrawnLayer &layer, const ScreenFinder &screen, double margin,
                        double smallestPixels)
{
    LayerInView view;
    for (const DrawnElement &element : layer.elements) {
        const double radius = element.radius + margin;
        const PixelRect rect = screen.rect(element.centre, radius);
        if (rect.isEmpty() || screen.pixels(element.centre, radius, 2 * radius) < smallestPixels)
            continue;
        view.rect = view.rect.with(rect);
        if (element.isMesh) {
            view.runs.push_back({&element, 0, 0, rect});
            continue;
        }
        if (view.runs.empty() || view.runs.back().mesh)
            view.runs.push_back({nullptr, std::uint32_t(view.commands.size()), 0, {}});
        DrawingRun &run = view.runs.back();
        run.rect = run.rect.with(rect);
        view.segments += element.range.count;
        DrawCommand *last = run.commandCount > 0 ? &view.commands.back() : nullptr;
        if (last && last->firstInstance + last->instances == element.range.first) {
            last->instances += element.range.count;
        } else {
            view.commands.push_back({36, element.range.count, 0, 0, element.range.first});
            ++run.commandCount;
        }
    }
    return view;
}

} // namespace ductus
