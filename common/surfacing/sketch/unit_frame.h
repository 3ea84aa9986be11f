// The unit frame all stages work in: box centre at the origin, box diagonal 1, so that the thesis' constants
// ("1 % of the diagonal") are plain numbers.
#pragma once

#include "surfacing/sketch/symmetry_plane.h"

namespace ductus {

struct UnitFrame
{
    Vec3 centre = Vec3::Zero(); // in input
    double diagonal = 1.0;      // input units

    Vec3 unitFromInput(const Vec3 &p) const { return (p - centre) / diagonal; }
    Vec3 inputFromUnit(const Vec3 &p) const { return p * diagonal + centre; }
    SymmetryPlane unitFromInput(const SymmetryPlane &plane) const
    {
        return {plane.normal, (plane.offset - plane.normal.dot(centre)) / diagonal};
    }
};

/// Of the strokes that carry surface.
UnitFrame unitFrameOf(const StrokeSet &strokes);

StrokeSet inUnitFrame(const StrokeSet &strokes, const UnitFrame &frame);
TriangleMesh inUnitFrame(const TriangleMesh &mesh, const UnitFrame &frame);
TriangleMesh inInputFrame(const TriangleMesh &mesh, const UnitFrame &frame);

} // namespace ductus
