// MeasureTool: two clicks on strokes or surface, and the length between them.
#pragma once

#include "geometry/triangle_mesh.h"
#include "sketchsurfacer/ui/viewport/view_tool.h"

#include <QString>
#include <functional>
#include <optional>

namespace ductus {

class MeasureTool : public ViewTool
{
public:
    /// \a measured gets the length in scene units of each finished measure.
    explicit MeasureTool(std::function<void(double)> measured) : mMeasured(std::move(measured)) {}

    void click(const ViewPointer &pointer, SketchView &view) override;
    void hover(const ViewPointer &pointer, SketchView &view) override;
    bool cancel(SketchView &view) override;
    void paint(QPainter &painter, const SketchView &view) const override;
    QCursor cursor() const override { return Qt::CrossCursor; }

private:
    std::optional<Vec3> pointAt(const QPointF &position, const SketchView &view) const;

    std::function<void(double)> mMeasured;
    std::optional<Vec3> mFrom, mTo, mUnder;
};

} // namespace ductus
