// SelectTool: clicks choose strokes and regions, a drag with Shift draws a lasso around strokes, a drag of
// chosen strokes moves them in the plane that faces the eye, a drag of a handle of the one that is chosen
// bends it; other drags turn the view. Hovering shows what a click would hit.
#pragma once

#include "geometry/triangle_mesh.h"
#include "sketchsurfacer/ui/tools/stroke_handles.h"

#include <QPolygonF>
#include <functional>
#include <optional>
#include <vector>

namespace ductus {

class SelectTool : public ViewTool
{
public:
    struct Actions
    {
        std::function<void(int line, bool extend)> strokeClicked;
        std::function<void(const QPointF &)> surfaceClicked;
        std::function<void()> nothingClicked;
        std::function<void(const std::vector<int> &lines, bool extend)> lassoed;
        std::function<bool(int line)> isChosen;
        std::function<void(const Vec3 &way)> moved; // of the chosen strokes, scene units
        StrokeHandles::Actions handles;
    };
    explicit SelectTool(Actions actions) : mActions(std::move(actions)), mHandles(mActions.handles) {}

    const StrokeHandles &handles() const { return mHandles; }

    bool press(const ViewPointer &pointer, SketchView &view) override;
    void drag(const ViewPointer &pointer, SketchView &view) override;
    void release(const ViewPointer &pointer, SketchView &view) override;
    void click(const ViewPointer &pointer, SketchView &view) override;
    void hover(const ViewPointer &pointer, SketchView &view) override;
    bool wheel(double steps, SketchView &view) override { return mHandles.wheel(steps, view); }
    bool cancel(SketchView &view) override;
    void paint(QPainter &painter, const SketchView &view) const override;

private:
    struct Move
    {
        Vec3 grabbed = Vec3::Zero(), way = Vec3::Zero();
    };

    Actions mActions;
    StrokeHandles mHandles;
    int mHovered = -1;
    QPolygonF mLasso; // empty: none is drawn
    std::optional<Move> mMove;
};

/// Indices of the lines of \a view of which more than half lies in \a lasso, whether something hides them or
/// not.
std::vector<int> linesInLasso(const QPolygonF &lasso, const SketchView &view);

} // namespace ductus
