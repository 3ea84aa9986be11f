// An iron with a closed handle (genus 1): everything between two side surfaces z = +-halfWidth(x, y) over a
// side view with a hole.
#include "support/solid_builder.h"

#include <cmath>
#include <numbers>

namespace ductus {

namespace {

/// Pointed towards the nose (x = 0.5), slim at the handle (y = 0.32).
double halfWidth(const Vec3 &p)
{
    const double along = (p.x() - 0.12) / 0.39, up = 1.0 - p.y() / 0.34;
    return 0.14 * (1.0 - along * along) * (0.22 + 0.78 * up * up);
}

/// The hole in the handle, \a turn 0..1, starting below its front and going up.
Vec3 holePoint(double turn)
{
    const double a = 2.0 * std::numbers::pi * (turn - 0.125);
    const double exponent = 2.0 / 3.0, c = std::cos(a), s = std::sin(a);
    const double x = std::copysign(std::pow(std::abs(c), exponent), c);
    const double y = std::copysign(std::pow(std::abs(s), exponent), s);
    return Vec3(0.185 + 0.115 * x + 0.02 * y, 0.195 + 0.052 * y, 0.0);
}

} // namespace

Solid iron(double length)
{
    SolidBuilder builder("iron", length / 0.5);
    const int soleCells = 48, noseCells = 3, overCells = 104, widthCells = 16, ringCells = 14;
    const Vec3 heel(0, 0, 0), tip(0.5, 0, 0), nose(0.497, 0.018, 0);
    // Side view, counter-clockwise from the tip: up the nose, over the handle to the heel, back along the
    // sole.
    const Polyline front = linePoints(tip, nose, noseCells);
    const Polyline over = splinePoints({nose, Vec3(0.43, 0.085, 0), Vec3(0.375, 0.165, 0),
                                        Vec3(0.33, 0.255, 0), Vec3(0.27, 0.302, 0), Vec3(0.17, 0.318, 0),
                                        Vec3(0.06, 0.3, 0), Vec3(0.01, 0.22, 0), Vec3(0.005, 0.1, 0), heel},
                                       overCells);
    const Polyline sole = linePoints(heel, tip, soleCells);
    const Polyline outline = joined(joined(front, over), sole);
    const int cells = int(outline.size()) - 1;
    Polyline hole;
    for (int i = 0; i <= cells; ++i)
        hole.push_back(holePoint(i == cells ? 0.0 : double(i) / cells));

    const auto onSide = [](double side) {
        return [side](const Vec3 &p) { return Vec3(p.x(), p.y(), side * halfWidth(p)); };
    };
    const auto band = [&](const Polyline &line) {
        return sampledGrid(int(line.size()) - 1, widthCells, [&](double u, double v) {
            const Vec3 &p = line[std::size_t(std::lround(u * double(line.size() - 1)))];
            return Vec3(p.x(), p.y(), (2.0 * v - 1.0) * halfWidth(p));
        });
    };
    const GridPatch cover = band(over);
    builder.addFaceGrid("nose", band(front));
    builder.addFaceGrid("cover", cover);
    builder.addFaceGrid("sole", band(sole));
    builder.addFaceGrid("inside of the handle", band(hole));
    for (const double side : {1.0, -1.0}) {
        const std::string name = side > 0 ? "right" : "left";
        GridPatch ring = sampledGrid(cells, ringCells, [&](double u, double v) -> Vec3 {
            const std::size_t i = std::size_t(std::lround(u * cells));
            return (1.0 - v) * hole[i] + v * outline[i];
        });
        ring.points = mapped(ring.points, onSide(side));
        builder.addFaceGrid(name + " side", ring);
        builder.addCurve(name + " cover edge", CurveKind::Border, mapped(over, onSide(side)));
        builder.addCurve(name + " sole edge", CurveKind::Border, mapped(sole, onSide(side)));
        builder.addCurve(name + " nose edge", CurveKind::Border, mapped(front, onSide(side)));
        builder.addCurve(name + " handle hole", CurveKind::Border, mapped(hole, onSide(side)));
        builder.addCurve(
            name + " water tank", CurveKind::Flow,
            mapped(splinePoints({Vec3(0.02, 0.05, 0), Vec3(0.2, 0.075, 0), Vec3(0.42, 0.06, 0)}, 40),
                   onSide(side)));
        builder.addCurve(name + " side rib", CurveKind::Flow,
                         mapped(linePoints(Vec3(0.2, 0, 0), Vec3(0.19, 0.143, 0), 20), onSide(side)));
    }
    builder.addCurve("cover ridge", CurveKind::Flow, cover.row(widthCells / 2));
    for (const int k : {20, 40, 60, 80})
        builder.addCurve("cover section", CurveKind::Flow, cover.column(k));
    builder.addCurve("tip edge", CurveKind::Border, band(front).column(0));
    builder.addCurve("nose top edge", CurveKind::Border, cover.column(0));
    builder.addCurve("heel edge", CurveKind::Border, cover.column(overCells));
    builder.addCurve("handle inside section", CurveKind::Flow, band(hole).column(cells / 4));
    builder.addCurve("handle inside section", CurveKind::Flow, band(hole).column(3 * cells / 4));
    return builder.finish(MirrorPlane{Vec3::UnitZ(), 0.0});
}

} // namespace ductus
