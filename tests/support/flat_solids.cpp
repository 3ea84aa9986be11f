// Solids with flat faces: bevelled box, L-bracket, house.
#include "support/solid_builder.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

int cellsOf(double length, double cell)
{
    return std::max(1, int(std::lround(length / cell)));
}

/// A flat face with its four border curves left to the caller.
void addQuad(SolidBuilder &builder, const std::string &name, const Vec3 &a, const Vec3 &b, const Vec3 &c,
             const Vec3 &d, int columnCells, int rowCells)
{
    builder.addFaceGrid(name, quadPatch(a, b, c, d, columnCells, rowCells));
}

void addLine(SolidBuilder &builder, const std::string &name, CurveKind kind, const Vec3 &a, const Vec3 &b,
             int cells)
{
    builder.addCurve(name, kind, linePoints(a, b, cells));
}

} // namespace

Solid bevelledBox(double width, double height, double depth, double bevel)
{
    SolidBuilder builder("bevelled-box");
    const double x = width / 2, z = depth / 2, wall = height - bevel;
    const int nx = 48, nz = 36, ny = 24, nb = 8;
    // Four corners a ring, counter-clockwise from above: bottom, top of the walls, top of the bevel.
    const auto ring = [](double rx, double y, double rz) {
        return std::array<Vec3, 4>{Vec3(-rx, y, rz), Vec3(rx, y, rz), Vec3(rx, y, -rz), Vec3(-rx, y, -rz)};
    };
    const auto bottom = ring(x, 0, z), shoulder = ring(x, wall, z), top = ring(x - bevel, height, z - bevel);
    const std::array<const char *, 4> sides{"front", "right", "back", "left"};
    for (int k = 0; k < 4; ++k) {
        const int l = (k + 1) % 4, n = k % 2 == 0 ? nx : nz;
        const std::string side = sides[k];
        addQuad(builder, side, bottom[k], bottom[l], shoulder[l], shoulder[k], n, ny);
        addQuad(builder, side + " bevel", shoulder[k], shoulder[l], top[l], top[k], n, nb);
        addLine(builder, side + " bottom edge", CurveKind::Border, bottom[k], bottom[l], n);
        addLine(builder, side + " bevel lower edge", CurveKind::Border, shoulder[k], shoulder[l], n);
        addLine(builder, side + " bevel upper edge", CurveKind::Border, top[k], top[l], n);
        addLine(builder, side + " vertical edge", CurveKind::Border, bottom[k], shoulder[k], ny);
        addLine(builder, side + " mitre", CurveKind::Border, shoulder[k], top[k], nb);
    }
    addQuad(builder, "bottom", bottom[0], bottom[1], bottom[2], bottom[3], nx, nz);
    addQuad(builder, "top", top[0], top[1], top[2], top[3], nx, nz);
    const GridPatch front = quadPatch(bottom[0], bottom[1], shoulder[1], shoulder[0], nx, ny);
    const GridPatch lid = quadPatch(top[0], top[1], top[2], top[3], nx, nz);
    builder.addCurve("drawer", CurveKind::Detail, drawnOn(front, parameterRectangle(0.12, 0.2, 0.88, 0.82)));
    builder.addCurve("knob", CurveKind::Detail, drawnOn(front, parameterEllipse(0.5, 0.51, 0.04, 0.084)));
    builder.addCurve("lid across", CurveKind::Flow,
                     drawnOn(lid, linePoints(Vec3(0.5, 0, 0), Vec3(0.5, 1, 0), 24)));
    return builder.finish(MirrorPlane{Vec3::UnitX(), 0.0});
}

Solid lBracket(double size, double thickness, double depth)
{
    SolidBuilder builder("l-bracket");
    const double cell = thickness / 8.0, half = depth / 2;
    // The outline as corners in the x-y plane; every border lies on the same lattice, so the pieces fit.
    const std::vector<Vec3> outline{Vec3(0, 0, 0),
                                    Vec3(thickness, 0, 0),
                                    Vec3(size, 0, 0),
                                    Vec3(size, thickness, 0),
                                    Vec3(thickness, thickness, 0),
                                    Vec3(thickness, size, 0),
                                    Vec3(0, size, 0),
                                    Vec3(0, thickness, 0)};
    const Vec3 front(0, 0, half), back(0, 0, -half);
    const int depthCells = cellsOf(depth, cell);
    // Runs of outline corners that form one flat wall.
    const std::vector<std::pair<std::string, std::vector<int>>> walls{
        {"underside", {0, 1, 2}}, {"toe", {2, 3}}, {"upper side", {3, 4}},
        {"inner wall", {4, 5}},   {"top", {5, 6}}, {"back wall", {6, 7, 0}}};
    for (const auto &[name, corners] : walls) {
        const int face = builder.addFace(name);
        Polyline run{outline[corners[0]]};
        for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
            const Vec3 &a = outline[corners[k]], &b = outline[corners[k + 1]];
            const int cells = cellsOf((b - a).norm(), cell);
            builder.addGrid(face, quadPatch(a + front, b + front, b + back, a + back, cells, depthCells));
            run = joined(run, linePoints(a, b, cells));
        }
        for (const Vec3 &shift : {front, back})
            builder.addCurve(name + (shift.z() > 0 ? " front edge" : " back edge"), CurveKind::Border,
                             mapped(run, [&](const Vec3 &p) -> Vec3 { return p + shift; }));
        builder.addCurve(name + " depth edge", CurveKind::Border,
                         linePoints(run.front() + front, run.front() + back, depthCells));
    }
    for (const Vec3 &shift : {front, back}) {
        const int face = builder.addFace(shift.z() > 0 ? "front cheek" : "back cheek");
        for (const auto &q : {std::array{0, 1, 4, 7}, std::array{1, 2, 3, 4}, std::array{7, 4, 5, 6}}) {
            const Vec3 &a = outline[q[0]], &b = outline[q[1]], &c = outline[q[2]], &d = outline[q[3]];
            builder.addGrid(face, quadPatch(a + shift, b + shift, c + shift, d + shift,
                                            cellsOf((b - a).norm(), cell), cellsOf((d - a).norm(), cell)));
        }
    }
    const double reach = size - thickness, y = thickness, x = thickness + reach * 0.55;
    const auto circle = [](const Vec3 &centre, const Vec3 &u, const Vec3 &v) {
        return mapped(parameterEllipse(0, 0, 1, 1),
                      [=](const Vec3 &p) -> Vec3 { return centre + p.x() * u + p.y() * v; });
    };
    const double radius = 0.16 * std::min(reach, depth);
    builder.addCurve("bolt hole below", CurveKind::Detail,
                     circle(Vec3(x, y, 0), radius * Vec3::UnitX(), radius * Vec3::UnitZ()));
    builder.addCurve("bolt hole above", CurveKind::Detail,
                     circle(Vec3(thickness, x, 0), radius * Vec3::UnitY(), radius * Vec3::UnitZ()));
    return builder.finish(MirrorPlane{Vec3::UnitZ(), 0.0});
}

Solid house(double width, double wallHeight, double roofHeight, double length)
{
    SolidBuilder builder("house");
    const double x = width / 2, z = length / 2, top = wallHeight + roofHeight;
    const int nx = 32, nz = 44, ny = 20, roof = 24;
    const auto at = [](double px, double py, double pz) { return Vec3(px, py, pz); };
    addQuad(builder, "floor", at(-x, 0, z), at(x, 0, z), at(x, 0, -z), at(-x, 0, -z), nx, nz);
    for (const double side : {1.0, -1.0}) {
        const std::string name = side > 0 ? "right" : "left";
        addQuad(builder, name + " wall", at(side * x, 0, z), at(side * x, 0, -z),
                at(side * x, wallHeight, -z), at(side * x, wallHeight, z), nz, ny);
        addQuad(builder, name + " roof", at(side * x, wallHeight, z), at(side * x, wallHeight, -z),
                at(0, top, -z), at(0, top, z), nz, roof);
        addLine(builder, name + " foot", CurveKind::Border, at(side * x, 0, z), at(side * x, 0, -z), nz);
        addLine(builder, name + " eaves", CurveKind::Border, at(side * x, wallHeight, z),
                at(side * x, wallHeight, -z), nz);
        addLine(builder, name + " rafter", CurveKind::Flow, at(side * x, wallHeight, 0), at(0, top, 0), roof);
    }
    for (const double end : {1.0, -1.0}) {
        const std::string name = end > 0 ? "front" : "back";
        const int face = builder.addFace(name + " gable");
        const GridPatch wall = quadPatch(at(-x, 0, end * z), at(x, 0, end * z), at(x, wallHeight, end * z),
                                         at(-x, wallHeight, end * z), nx, ny);
        builder.addGrid(face, wall);
        builder.addGrid(face, quadPatch(at(-x, wallHeight, end * z), at(x, wallHeight, end * z),
                                        at(0, top, end * z), at(0, top, end * z), nx, roof));
        addLine(builder, name + " foot", CurveKind::Border, at(-x, 0, end * z), at(x, 0, end * z), nx);
        for (const double side : {1.0, -1.0}) {
            addLine(builder, name + " corner", CurveKind::Border, at(side * x, 0, end * z),
                    at(side * x, wallHeight, end * z), ny);
            addLine(builder, name + " verge", CurveKind::Border, at(side * x, wallHeight, end * z),
                    at(0, top, end * z), roof);
        }
        if (end > 0) {
            builder.addCurve("door", CurveKind::Detail,
                             drawnOn(wall, parameterRectangle(0.38, 0.0, 0.62, 0.72)));
            builder.addCurve("left window", CurveKind::Detail,
                             drawnOn(wall, parameterRectangle(0.1, 0.4, 0.28, 0.75)));
            builder.addCurve("right window", CurveKind::Detail,
                             drawnOn(wall, parameterRectangle(0.72, 0.4, 0.9, 0.75)));
        }
    }
    addLine(builder, "ridge", CurveKind::Border, at(0, top, z), at(0, top, -z), nz);
    return builder.finish(MirrorPlane{Vec3::UnitX(), 0.0});
}

} // namespace ductus
