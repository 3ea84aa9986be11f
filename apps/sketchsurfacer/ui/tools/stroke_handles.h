// StrokeHandles: a few handles on the one stroke that is chosen. A drag takes a handle along in the plane
// that faces the eye, or over the surface, to other strokes where it meets them; the stroke bends with it.
// Part of the select tool.
#pragma once

#include "sketchsurfacer/ui/viewport/view_tool.h"
#include "strokes/bend.h"

#include <functional>
#include <optional>
#include <vector>

namespace ductus {

class StrokeHandles
{
public:
    struct Actions
    {
        std::function<int()> chosenLine; // index into the lines of the view, -1: none or several
        std::function<void(const StrokeBend &)> bent;
    };
    explicit StrokeHandles(Actions actions) : mActions(std::move(actions)) {}

    /// Handles as they are on the screen now; none where no single stroke is chosen or seen.
    std::vector<StrokeHandle> handles(const SketchView &view) const;

    // As in ViewTool; true: the handles took it.
    bool press(const ViewPointer &pointer, const SketchView &view);
    bool drag(const ViewPointer &pointer, const SketchView &view);
    bool release();
    bool hover(const ViewPointer &pointer, const SketchView &view);
    bool wheel(double steps, const SketchView &view);
    bool cancel();
    void paint(QPainter &painter, const SketchView &view) const;

private:
    struct Drag
    {
        StrokeBend bend;
        Vec3 grabbed = Vec3::Zero();
        QPointF from;
        bool snaps = false; // to another stroke at the moment
        bool moved = false;
    };

    const std::vector<Vec3> *line(const SketchView &view) const;
    int handleAt(const QPointF &position, const SketchView &view) const;
    Vec3 target(const ViewPointer &pointer, const SketchView &view, bool *snaps) const;

    Actions mActions;
    int mHovered = -1;
    double mReachFactor = 1.5; // times the step between two handles
    std::optional<Drag> mDrag;
};

} // namespace ductus
