// Surfaces of revolution: can, bottle, table lamp, torus, ellipsoid (scaled).
#include "support/solid_builder.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace ductus {

namespace {

constexpr int around = 96; // cells; divisible by 8 so that drawn meridians run along mesh edges

/// One smooth piece of the profile: knots (radius, height), a straight line if there are two.
struct ProfilePiece
{
    std::string name;
    std::vector<Vec3> knots;
    int cells = 16;
    int meridians = 0;         // curves drawn along it
    std::vector<double> rings; // extra cross-sections, as share of the piece
};

Vec3 at(double radius, double height)
{
    return Vec3(radius, height, 0.0);
}

/// Turns the pieces, which follow one another, into faces; circles are drawn where two meet.
void addRevolution(SolidBuilder &builder, const std::vector<ProfilePiece> &pieces,
                   double firstMeridian = 0.125)
{
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const ProfilePiece &piece = pieces[k];
        const GridPatch grid = revolvedPatch(splinePoints(piece.knots, piece.cells), around);
        builder.addFaceGrid(piece.name, grid);
        if (k + 1 < pieces.size())
            builder.addCurve(piece.name + " upper ring", CurveKind::Border, grid.row(grid.rows - 1));
        for (const double share : piece.rings)
            builder.addCurve(piece.name + " ring", CurveKind::Flow,
                             grid.row(int(std::lround(share * piece.cells))));
        for (int m = 0; m < piece.meridians; ++m) {
            const double turn = std::fmod(firstMeridian + double(m) / piece.meridians, 1.0);
            builder.addCurve(piece.name + " meridian", CurveKind::Flow,
                             grid.column(int(std::lround(turn * around))));
        }
    }
}

/// The x-y plane: with meridians at 1/8 turn the drawn ones come in pairs.
const MirrorPlane frontPlane{Vec3::UnitZ(), 0.0};

} // namespace

Solid can(double radius, double height)
{
    SolidBuilder builder("can");
    addRevolution(builder, {{"bottom", {at(0, 0), at(radius, 0)}, 16, 0, {}},
                            {"wall", {at(radius, 0), at(radius, height)}, 40, 4, {0.5}},
                            {"lid", {at(radius, height), at(0, height)}, 16, 0, {}}});
    // The pull tab.
    const auto tab = mapped(parameterEllipse(0.3, 0, 0.28, 0.16),
                            [&](const Vec3 &p) { return Vec3(p.x() * radius, height, p.y() * radius); });
    builder.addCurve("tab", CurveKind::Detail, tab);
    return builder.finish(frontPlane);
}

Solid bottle(double bodyRadius, double height)
{
    SolidBuilder builder("bottle");
    const double r = bodyRadius, h = height;
    const std::vector<Vec3> body{at(0.9 * r, 0), at(0.97 * r, 0.2 * h), at(0.98 * r, 0.4 * h),
                                 at(r, 0.52 * h)};
    addRevolution(builder, {{"bottom", {at(0, 0), at(0.9 * r, 0)}, 14, 0, {}},
                            {"body", body, 40, 4, {0.25, 0.6}},
                            {"shoulder and neck",
                             {at(r, 0.52 * h), at(0.72 * r, 0.62 * h), at(0.44 * r, 0.73 * h),
                              at(0.34 * r, 0.83 * h), at(0.32 * r, 0.92 * h)},
                             36,
                             4,
                             {0.5}},
                            {"under the rim", {at(0.32 * r, 0.92 * h), at(0.45 * r, 0.92 * h)}, 6, 0, {}},
                            {"rim", {at(0.45 * r, 0.92 * h), at(0.45 * r, h)}, 10, 4, {}},
                            {"cork", {at(0.45 * r, h), at(0, h)}, 12, 0, {}}});
    // The label on the front: a part of the body, drawn as one loop.
    const GridPatch grid = revolvedPatch(splinePoints(body, 40), around);
    builder.addCurve("label", CurveKind::Detail, drawnOn(grid, parameterRectangle(0.14, 0.28, 0.36, 0.84)));
    return builder.finish(MirrorPlane{Vec3::UnitX(), 0.0});
}

Solid tableLamp(double height)
{
    SolidBuilder builder("table-lamp");
    const double h = height, stem = 0.035 * h;
    addRevolution(
        builder,
        {{"bottom", {at(0, 0), at(0.27 * h, 0)}, 16, 0, {}},
         {"foot edge", {at(0.27 * h, 0), at(0.27 * h, 0.05 * h)}, 5, 0, {}},
         {"foot",
          {at(0.27 * h, 0.05 * h), at(0.19 * h, 0.1 * h), at(0.09 * h, 0.13 * h), at(stem, 0.14 * h)},
          22,
          4,
          {}},
         {"stem", {at(stem, 0.14 * h), at(stem, 0.6 * h)}, 40, 4, {0.5}},
         {"under the shade", {at(stem, 0.6 * h), at(0.36 * h, 0.54 * h)}, 28, 4, {}},
         {"shade", {at(0.36 * h, 0.54 * h), at(0.19 * h, 0.9 * h)}, 32, 8, {0.5}},
         {"cap",
          {at(0.19 * h, 0.9 * h), at(0.15 * h, 0.955 * h), at(0.08 * h, 0.99 * h), at(0, h)},
          20,
          4,
          {}}});
    return builder.finish(frontPlane);
}

Solid torus(double majorRadius, double minorRadius)
{
    SolidBuilder builder("torus");
    const auto point = [&](double u, double v) {
        const double a = 2.0 * std::numbers::pi * u, b = 2.0 * std::numbers::pi * v;
        const double r = majorRadius + minorRadius * std::cos(b);
        return Vec3(r * std::cos(a), minorRadius * std::sin(b), r * std::sin(a));
    };
    const GridPatch grid = sampledGrid(128, 48, point);
    builder.addFaceGrid("ring", grid);
    for (const int row : {0, 12, 24, 36})
        builder.addCurve("along the ring", CurveKind::Flow, grid.row(row));
    for (int k = 0; k < 8; ++k)
        builder.addCurve("around the tube", CurveKind::Flow, grid.column(16 * k));
    return builder.finish(frontPlane);
}

Solid ellipsoid(const Vec3 &radii)
{
    SolidBuilder builder("ellipsoid");
    const GridPatch grid = sampledGrid(around, 48, [&](double u, double v) -> Vec3 {
        const double a = 2.0 * std::numbers::pi * u, b = std::numbers::pi * (v - 0.5);
        // Exact poles, so that the cells there weld into a fan.
        const double ring = v <= 0.0 || v >= 1.0 ? 0.0 : std::cos(b);
        return radii.cwiseProduct(Vec3(ring * std::cos(a), std::sin(b), ring * std::sin(a)));
    });
    builder.addFaceGrid("skin", grid);
    for (const int row : {12, 24, 36})
        builder.addCurve("parallel", CurveKind::Flow, grid.row(row));
    for (const int column : {0, around / 8, around / 4, 3 * around / 8})
        builder.addCurve("meridian", CurveKind::Flow,
                         joined(grid.column(column), reversed(grid.column(column + around / 2))));
    return builder.finish(frontPlane);
}

} // namespace ductus
