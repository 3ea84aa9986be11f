// Open shells: a saddle, and a leaf folded along its midrib.
#include "support/solid_builder.h"

namespace ductus {

Solid saddle(double size, double rise)
{
    SolidBuilder builder("saddle");
    const GridPatch grid = sampledGrid(48, 48, [&](double u, double v) {
        const double x = 2.0 * u - 1.0, z = 2.0 * v - 1.0;
        return Vec3(0.5 * size * x, rise * (x * x - 0.7 * z * z), 0.5 * size * z);
    });
    builder.addFaceGrid("seat", grid);
    builder.addCurve("front border", CurveKind::Boundary, grid.row(48));
    builder.addCurve("back border", CurveKind::Boundary, grid.row(0));
    builder.addCurve("left border", CurveKind::Boundary, grid.column(0));
    builder.addCurve("right border", CurveKind::Boundary, grid.column(48));
    for (const int k : {12, 24, 36}) {
        builder.addCurve("along", CurveKind::Flow, grid.row(k));
        builder.addCurve("across", CurveKind::Flow, grid.column(k));
    }
    return builder.finish(MirrorPlane{Vec3::UnitZ(), 0.0});
}

Solid bentLeaf(double length, double foldSlope)
{
    SolidBuilder builder("bent-leaf", length);
    // s runs from stalk to tip, t from the midrib to the margin. Both halves rise from the midrib and droop
    // outside.
    const auto half = [&](double side) {
        return sampledGrid(72, 20, [&, side](double s, double t) {
            const double width = 1.35 * s * (1.0 - s) * (1.25 - 0.6 * s);
            const double across = t * width;
            const double arch = 0.75 * s * (1.0 - s) - 0.16 * s;
            return Vec3(s, arch + foldSlope * across - 0.55 * across * across, side * across);
        });
    };
    for (const double side : {1.0, -1.0}) {
        const GridPatch grid = half(side);
        const std::string name = side > 0 ? "right" : "left";
        builder.addFaceGrid(name + " half", grid);
        builder.addCurve(name + " margin", CurveKind::Boundary, grid.row(20));
        // Side veins sweep towards the tip.
        for (int k = 0; k < 5; ++k) {
            const double s = 0.12 + 0.155 * k;
            builder.addCurve(
                name + " vein", CurveKind::Flow,
                drawnOn(grid,
                        splinePoints({Vec3(s, 0, 0), Vec3(s + 0.06, 0.45, 0), Vec3(s + 0.14, 1, 0)}, 24)));
        }
        if (side > 0)
            builder.addCurve("midrib", CurveKind::Border, grid.row(0));
    }
    return builder.finish(MirrorPlane{Vec3::UnitZ(), 0.0});
}

} // namespace ductus
