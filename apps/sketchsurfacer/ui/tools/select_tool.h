// SelectTool: clicks choose strokes and regions, drags turn the view, hovering shows what a click would hit.
#pragma once

#include "sketchsurfacer/ui/viewport/view_tool.h"

#include <functional>

namespace ductus {

class SelectTool : public ViewTool
{
public:
    struct Actions
    {
        std::function<void(int line, bool extend)> strokeClicked;
        std::function<void(const QPointF &)> surfaceClicked;
        std::function<void()> nothingClicked;
    };
    explicit SelectTool(Actions actions) : mActions(std::move(actions)) {}

    void click(const ViewPointer &pointer, SketchView &view) override;
    void hover(const ViewPointer &pointer, SketchView &view) override;
    bool cancel(SketchView &view) override;
    void paint(QPainter &painter, const SketchView &view) const override;

private:
    Actions mActions;
    int mHovered = -1;
};

} // namespace ductus
