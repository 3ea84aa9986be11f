#include "sketchsurfacer/ui/tools/select_tool.h"

#include "sketchsurfacer/ui/tools/painted_line.h"
#include "sketchsurfacer/ui/viewport/sketch_view.h"

namespace ductus {

void SelectTool::click(const ViewPointer &pointer, SketchView &view)
{
    const bool extend = pointer.modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
    const int line =
        view.areStrokesShown() || view.mode() == ViewMode::Sketch ? view.strokeAt(pointer.position) : -1;
    if (line >= 0)
        mActions.strokeClicked(line, extend);
    else if (view.surfaceAt(pointer.position))
        mActions.surfaceClicked(pointer.position);
    else if (!extend)
        mActions.nothingClicked();
}

void SelectTool::hover(const ViewPointer &pointer, SketchView &view)
{
    mHovered =
        view.areStrokesShown() || view.mode() == ViewMode::Sketch ? view.strokeAt(pointer.position) : -1;
    view.setCursor(mHovered >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

bool SelectTool::cancel(SketchView &)
{
    mHovered = -1;
    return false;
}

void SelectTool::paint(QPainter &painter, const SketchView &view) const
{
    if (mHovered >= 0 && mHovered < int(view.strokes().size()))
        paintLine(painter, view, view.strokes()[std::size_t(mHovered)].points, QColor(255, 214, 110), 2.5);
}

} // namespace ductus
