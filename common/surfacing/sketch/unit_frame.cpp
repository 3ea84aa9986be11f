#include "surfacing/sketch/unit_frame.h"

namespace ductus {

UnitFrame unitFrameOf(const StrokeSet &strokes)
{
    Box3 box;
    for (const Stroke &stroke : strokes.strokes)
        if (stroke.role == StrokeRole::Surface || stroke.role == StrokeRole::Boundary)
            for (const Vec3 &p : stroke.points)
                box.add(p);
    UnitFrame frame;
    if (!box.isEmpty() && box.diagonal() > 0.0) {
        frame.centre = box.centre();
        frame.diagonal = box.diagonal();
    }
    return frame;
}

StrokeSet inUnitFrame(const StrokeSet &strokes, const UnitFrame &frame)
{
    StrokeSet result = strokes;
    for (Stroke &stroke : result.strokes)
        for (Vec3 &p : stroke.points)
            p = frame.unitFromInput(p);
    return result;
}

TriangleMesh inUnitFrame(const TriangleMesh &mesh, const UnitFrame &frame)
{
    TriangleMesh result = mesh;
    for (Vec3 &p : result.vertices)
        p = frame.unitFromInput(p);
    return result;
}

TriangleMesh inInputFrame(const TriangleMesh &mesh, const UnitFrame &frame)
{
    TriangleMesh result = mesh;
    for (Vec3 &p : result.vertices)
        p = frame.inputFromUnit(p);
    return result;
}

} // namespace ductus
