// A computer mouse: flat underside, leaning side wall, one quartic dome on top; a sharp belt where wall and
// dome meet.
#include "support/solid_builder.h"

#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr int around = 128;

/// Outline seen from above at \a turn (0..1, 0 = front, +x), scaled by \a share of its size. Length 1.1.
Vec3 outlinePoint(double turn, double share)
{
    const double a = 2.0 * std::numbers::pi * turn;
    const double c = std::cos(a), s = std::sin(a);
    const double exponent = 2.0 / 2.5; // superellipse
    const double x = 0.55 * std::copysign(std::pow(std::abs(c), exponent), c);
    const double z = 0.32 * std::copysign(std::pow(std::abs(s), exponent), s);
    const double waist = 1.0 - 0.12 * std::exp(-18.0 * (x - 0.08) * (x - 0.08)) - 0.1 * x;
    return Vec3(share * x, 0.0, share * waist * z);
}

/// z of the outline at \a x, found by halving: x falls from the front (turn 0) to the back (turn 0.5).
double outlineWidth(double x)
{
    double front = 0.0, back = 0.5;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (front + back);
        (outlinePoint(middle, 1.0).x() > x ? front : back) = middle;
    }
    return outlinePoint(front, 1.0).z();
}

double domeHeight(double x, double z)
{
    return 0.30 - 0.12 * x - 0.38 * x * x - 0.35 * x * x * x * x - 1.25 * z * z - 1.0 * z * z * z * z;
}

Vec3 onDome(const Vec3 &p)
{
    return Vec3(p.x(), domeHeight(p.x(), p.z()), p.z());
}

} // namespace

Solid computerMouse(double length)
{
    SolidBuilder builder("computer-mouse", length / 1.1);
    const auto turnOf = [](double u) { return u >= 1.0 ? 0.0 : u; };
    const GridPatch dome =
        sampledGrid(around, 36, [&](double u, double v) { return onDome(outlinePoint(turnOf(u), 1.0 - v)); });
    const GridPatch wall = sampledGrid(around, 14, [&](double u, double v) -> Vec3 {
        const Vec3 foot = outlinePoint(turnOf(u), 0.93), belt = onDome(outlinePoint(turnOf(u), 1.0));
        const double bulge = 0.06 * v * (1.0 - v);
        const Vec3 outwards = outlinePoint(turnOf(u), 1.0);
        return (1.0 - v) * foot + v * belt + bulge * outwards;
    });
    const GridPatch bottom = sampledGrid(
        around, 24, [&](double u, double v) { return outlinePoint(turnOf(u), 0.93 * (1.0 - v)); });
    builder.addFaceGrid("dome", dome);
    builder.addFaceGrid("wall", wall);
    builder.addFaceGrid("underside", bottom);
    builder.addCurve("belt", CurveKind::Border, dome.row(0));
    builder.addCurve("foot", CurveKind::Border, bottom.row(0));
    for (int k = 0; k < 8; ++k)
        builder.addCurve("wall rib", CurveKind::Flow, wall.column(k * around / 8));
    builder.addCurve("spine", CurveKind::Flow, joined(dome.column(0), reversed(dome.column(around / 2))));
    for (const double x : {-0.38, -0.2, 0.28}) {
        const double z = outlineWidth(x);
        builder.addCurve("across", CurveKind::Flow,
                         mapped(linePoints(Vec3(x, 0, z), Vec3(x, 0, -z), 48), onDome));
    }
    // The two keys: gaps beside the wheel, and a line across behind them.
    const auto domeLine = [](const std::vector<Vec3> &knots) {
        return mapped(splinePoints(knots, 40), onDome);
    };
    for (const double side : {1.0, -1.0})
        builder.addCurve(
            "key gap", CurveKind::Detail,
            domeLine({Vec3(0.52, 0, 0.035 * side), Vec3(0.3, 0, 0.04 * side), Vec3(0.1, 0, 0.03 * side)}));
    builder.addCurve("behind the keys", CurveKind::Detail,
                     domeLine({Vec3(0.14, 0, -0.25), Vec3(0.06, 0, 0), Vec3(0.14, 0, 0.25)}));
    builder.addCurve("wheel", CurveKind::Detail,
                     mapped(parameterEllipse(0.3, 0, 0.085, 0.028),
                            [](const Vec3 &p) { return onDome(Vec3(p.x(), 0, p.y())); }));
    builder.addCurve("thumb key", CurveKind::Detail,
                     drawnOn(wall, parameterRectangle(0.19, 0.45, 0.31, 0.75)));
    return builder.finish(MirrorPlane{Vec3::UnitZ(), 0.0});
}

} // namespace ductus
