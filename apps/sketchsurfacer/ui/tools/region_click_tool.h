// RegionClickTool: acts on the region that is clicked; drags turn the view.
#pragma once

#include "sketchsurfacer/ui/viewport/view_tool.h"

#include <functional>

namespace ductus {

class RegionClickTool : public ViewTool
{
public:
    explicit RegionClickTool(std::function<void(const QPointF &)> clicked) : mClicked(std::move(clicked)) {}

    void click(const ViewPointer &pointer, SketchView &) override { mClicked(pointer.position); }
    QCursor cursor() const override { return Qt::PointingHandCursor; }

private:
    std::function<void(const QPointF &)> mClicked;
};

} // namespace ductus
