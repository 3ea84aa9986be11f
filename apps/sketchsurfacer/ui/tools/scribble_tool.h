// ScribbleTool: a line drawn over the surface, for new regions, merges, seams and the like. Beside the
// surface the drag turns the view.
#pragma once

#include "sketchsurfacer/ui/viewport/view_tool.h"
#include "surfacing/refinement/scribble.h"

#include <functional>
#include <vector>

namespace ductus {

class ScribbleTool : public ViewTool
{
public:
    /// \a done gets each scribble of at least \a leastPoints points.
    ScribbleTool(ScribbleKind kind, QColor colour, int leastPoints,
                 std::function<void(const Scribble &)> done);

    ScribbleKind kind() const { return mKind; }
    void setKind(ScribbleKind kind, QColor colour, int leastPoints);

    bool press(const ViewPointer &pointer, SketchView &view) override;
    void drag(const ViewPointer &pointer, SketchView &view) override;
    void release(const ViewPointer &pointer, SketchView &view) override;
    void hover(const ViewPointer &pointer, SketchView &view) override;
    bool cancel(SketchView &view) override;
    void paint(QPainter &painter, const SketchView &view) const override;
    QCursor cursor() const override { return Qt::CrossCursor; }

private:
    void add(const QPointF &position, const SketchView &view);

    ScribbleKind mKind;
    QColor mColour;
    int mLeastPoints;
    std::function<void(const Scribble &)> mDone;
    std::vector<Vec3> mPoints;
    QPointF mLast, mHover;
    bool mIsOverSurface = false;
    bool mIsDrawing = false;
};

} // namespace ductus
