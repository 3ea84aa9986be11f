// DrawStrokeTool: a new stroke on the surface, or where there is none on the plane that faces the eye through
// the point where the last stroke ended. Starts near strokes snap to them.
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
    std::optional<Vec3> mSnap; // what a press now would begin at
    QPointF mLast;
    bool mIsDrawing = false;
};

} // namespace ductus
