// DrawStrokeTool: a new stroke on the surface, or where there is none on the plane that faces the eye through
// the point where the last stroke ended. Ends near strokes snap to them, and so does the line where it
// crosses some: from stroke to stroke it runs at their height, also where the surface does not
// (stroke_snap.h).
#pragma once

#include "geometry/triangle_mesh.h"
#include "sketchsurfacer/ui/viewport/view_tool.h"

#include <functional>
#include <optional>
#include <vector>

namespace ductus {

class DrawStrokeTool : public ViewTool
{
public:
    explicit DrawStrokeTool(std::function<void(const std::vector<Vec3> &)> done) : mDone(std::move(done)) {}

    bool press(const ViewPointer &pointer, SketchView &view) override;
    void drag(const ViewPointer &pointer, SketchView &view) override;
    void release(const ViewPointer &pointer, SketchView &view) override;
    void hover(const ViewPointer &pointer, SketchView &view) override;
    bool cancel(SketchView &view) override;
    void paint(QPainter &painter, const SketchView &view) const override;
    QCursor cursor() const override { return Qt::CrossCursor; }

private:
    Vec3 pointAt(const QPointF &position, const SketchView &view) const;

    std::function<void(const std::vector<Vec3> &)> mDone;
    std::vector<Vec3> mPoints;
    std::optional<Vec3> mLastEnd;
    std::optional<Vec3> mSnap;       // what a press now would begin at
    std::vector<QPointF> mPositions; // pixels, beside mPoints
    bool mIsDrawing = false;
};

} // namespace ductus
