// A saloon car in full size (metres), scaled down to the desk: x forwards, y up, mirrored at z = 0. Lower
// sides lie on one smooth surface z = +-W(x, y); all other panels are Coons patches between the feature
// lines, and panels that cross the mirror plane are built across it, so they are smooth there.
#include "support/solid_builder.h"

#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr double scale = 0.2; // a car of 4.3 m becomes one of 0.86 m

// Cells along the feature lines; opposite borders of a panel have the same sum.
constexpr int acrossCells = 40, pillarCells = 20, cornerCells = 20;
constexpr int fenderCells = 34, beltCells = 68, rearCells = 18;
constexpr int lipCells = 10, archCells = 28,
              sillCells = 44; // arches narrower than the columns above: no folds

/// Everything drawn in the side view (z = 0) or on the right half (z > 0), and how a line crosses to the
/// left.
class CarLines
{
public:
    explicit CarLines(const CarShape &shape) : mShape(shape)
    {
        const Vec3 cowl = side(1.0, 0.87), boot = side(-1.42, 0.95);
        const Polyline shoulder =
            splinePoints({side(2.06, 0.60), side(1.75, 0.735), side(1.35, 0.82), cowl, side(0.2, 0.915),
                          side(-0.6, 0.935), boot, side(-1.8, 0.935), side(-2.1, 0.885)},
                         fenderCells + beltCells + rearCells);
        // Even cells leave the panel corners between two points; cut there instead.
        fender = splinePoints(between(shoulder, shoulder.front().x(), cowl.x()), fenderCells);
        belt = splinePoints(between(shoulder, cowl.x(), boot.x()), beltCells);
        rear = splinePoints(between(shoulder, boot.x(), shoulder.back().x()), rearCells);
        for (Polyline *line : {&fender, &belt, &rear})
            *line = mapped(*line, [&](const Vec3 &p) { return onSide(p); });
        const Vec3 frontHeader = cabin(0.30, 1.32, 0.575), rearHeader = cabin(-0.92, 1.31, 0.555);
        roofRail = splinePoints({frontHeader, cabin(-0.28, 1.385, 0.595), rearHeader}, beltCells);
        frontPillar = splinePoints({belt.front(), cabin(0.68, 1.105, 0.725), frontHeader}, pillarCells);
        rearPillar = splinePoints({belt.back(), cabin(-1.2, 1.14, 0.70), rearHeader}, pillarCells);
        noseCorner = mapped(splinePoints({Vec3(1.98, 0.22, 0), Vec3(2.07, 0.40, 0),
                                          fender.front().cwiseProduct(Vec3(1, 1, 0))},
                                         cornerCells),
                            [&](const Vec3 &p) { return onSide(p); });
        tailCorner = mapped(
            splinePoints({Vec3(-2.0, 0.26, 0), Vec3(-2.11, 0.55, 0), rear.back().cwiseProduct(Vec3(1, 1, 0))},
                         cornerCells),
            [&](const Vec3 &p) { return onSide(p); });
        buildSill();
    }

    /// Half width of the lower body: tapers to both ends in plan, tucks in towards sill and belt.
    static double halfWidth(double x, double y)
    {
        const double t = x / 2.1, v = y - 0.66;
        return 0.89 - 0.05 * t * t - 0.115 * t * t * t * t - 0.02 * t - 0.24 * v * v;
    }

    Vec3 onSide(const Vec3 &p) const { return Vec3(p.x(), p.y(), halfWidth(p.x() / mShape.length, p.y())); }

    /// From right to left through \a crown, the offset of the middle from the straight line.
    static Polyline across(const Vec3 &right, const Vec3 &crown)
    {
        Polyline line;
        for (int i = 0; i <= acrossCells; ++i) {
            const double t = 1.0 - 2.0 * i / acrossCells; // 1 right, -1 left
            line.push_back(Vec3(right.x(), right.y(), right.z() * t) + (1.0 - t * t) * crown);
        }
        return line;
    }

    Polyline fender, belt, rear;                // nose -> cowl -> boot -> tail
    Polyline roofRail, frontPillar, rearPillar; // front -> rear; bottom -> top
    Polyline noseCorner, tailCorner;            // bottom -> top
    std::vector<Polyline> bottom;               // nose -> tail: lip, arch, sill, arch, lip
    std::array<Vec3, 2> wheels;                 // centres in the side view
    static constexpr double archRadius = 0.355;

private:
    Vec3 side(double x, double y) const { return Vec3(x * mShape.length, y, 0.0); }
    Vec3 cabin(double x, double y, double z) const
    {
        return Vec3(x * mShape.length, 0.93 + (y - 0.93) * mShape.height, z);
    }

    static std::vector<Vec3> between(const Polyline &line, double fromX, double toX)
    {
        const auto atX = [&](double x) -> Vec3 {
            std::size_t i = 1;
            while (i + 1 < line.size() && line[i].x() > x)
                ++i;
            return line[i - 1] +
                   (line[i] - line[i - 1]) * ((x - line[i - 1].x()) / (line[i].x() - line[i - 1].x()));
        };
        std::vector<Vec3> knots{atX(fromX)};
        for (const Vec3 &p : line)
            if (p.x() < fromX - 0.02 && p.x() > toX + 0.02)
                knots.push_back(p);
        knots.push_back(atX(toX));
        return knots;
    }

    void buildSill()
    {
        const double y = 0.22, centreY = mShape.cutArches ? y : 0.27,
                     reach = std::sqrt(archRadius * archRadius - (y - centreY) * (y - centreY));
        wheels = {side(1.3, centreY), side(-1.3, centreY)};
        const auto arch = [&](const Vec3 &centre) {
            const double begin = std::atan2(y - centreY, reach), end = std::numbers::pi - begin;
            Polyline line;
            for (int i = 0; i <= archCells; ++i) {
                const double a = begin + (end - begin) * i / archCells;
                line.push_back(centre + archRadius * Vec3(std::cos(a), std::sin(a), 0.0));
            }
            return mShape.cutArches ? line : linePoints(line.front(), line.back(), archCells);
        };
        const Polyline front = arch(wheels[0]), back = arch(wheels[1]);
        const auto flat = [](const Vec3 &p) { return Vec3(p.x(), p.y(), 0.0); };
        bottom = {linePoints(flat(noseCorner.front()), front.front(), lipCells), front,
                  linePoints(front.back(), back.front(), sillCells), back,
                  linePoints(back.back(), flat(tailCorner.front()), lipCells)};
        for (Polyline &line : bottom)
            line = mapped(line, [&](const Vec3 &p) { return onSide(p); });
    }

    CarShape mShape;
};

Vec3 mirrored(const Vec3 &p)
{
    return Vec3(p.x(), p.y(), -p.z());
}

void addBoth(SolidBuilder &builder, const std::string &name, CurveKind kind, const Polyline &right)
{
    builder.addCurve("right " + name, kind, right);
    builder.addCurve("left " + name, kind, mapped(right, mirrored));
}

void addFaceBoth(SolidBuilder &builder, const std::string &name, const GridPatch &right)
{
    builder.addFaceGrid("right " + name, right);
    builder.addFaceGrid("left " + name, {right.rows, right.columns, mapped(right.points, mirrored)});
}

/// A panel over the mirror plane: rows run from right to left, columns along \a rightBorder.
GridPatch acrossPanel(const Polyline &first, const Polyline &last, const Polyline &rightBorder)
{
    return coonsPatch(first, last, rightBorder, mapped(rightBorder, mirrored));
}

Polyline straightUv(double u0, double v0, double u1, double v1)
{
    return linePoints(Vec3(u0, v0, 0), Vec3(u1, v1, 0), 32);
}

} // namespace

Solid car(const CarShape &shape)
{
    SolidBuilder builder(shape.cutArches ? "car-cut-arches" : "car", scale);
    const CarLines lines(shape);

    const Polyline noseEdge = CarLines::across(lines.fender.front(), Vec3(0.17, 0.045, 0));
    const Polyline noseFoot = CarLines::across(lines.noseCorner.front(), Vec3(0.15, 0, 0));
    const Polyline cowl = CarLines::across(lines.fender.back(), Vec3(0.2, 0.05, 0));
    const Polyline frontHeader = CarLines::across(lines.roofRail.front(), Vec3(0.12, 0.06, 0));
    const Polyline rearHeader = CarLines::across(lines.roofRail.back(), Vec3(-0.09, 0.06, 0));
    const Polyline bootFront = CarLines::across(lines.belt.back(), Vec3(-0.16, 0.03, 0));
    const Polyline tailEdge = CarLines::across(lines.rear.back(), Vec3(-0.12, 0.035, 0));
    const Polyline tailFoot = CarLines::across(lines.tailCorner.front(), Vec3(-0.09, 0, 0));

    const GridPatch nose = acrossPanel(noseFoot, noseEdge, lines.noseCorner);
    const GridPatch hood = acrossPanel(noseEdge, cowl, lines.fender);
    const GridPatch windscreen = acrossPanel(cowl, frontHeader, lines.frontPillar);
    const GridPatch roof = acrossPanel(frontHeader, rearHeader, lines.roofRail);
    const GridPatch rearWindow = acrossPanel(rearHeader, bootFront, reversed(lines.rearPillar));
    const GridPatch boot = acrossPanel(bootFront, tailEdge, lines.rear);
    const GridPatch tail = acrossPanel(tailFoot, tailEdge, lines.tailCorner);
    builder.addFaceGrid("nose", nose);
    builder.addFaceGrid("hood", hood);
    builder.addFaceGrid("windscreen", windscreen);
    builder.addFaceGrid("roof", roof);
    builder.addFaceGrid("rear window", rearWindow);
    builder.addFaceGrid("boot", boot);
    builder.addFaceGrid("tail", tail);

    const GridPatch windows = coonsPatch(lines.belt, lines.roofRail, lines.frontPillar, lines.rearPillar);
    addFaceBoth(builder, "windows", windows);
    Polyline sill = lines.bottom[0];
    for (std::size_t k = 1; k < lines.bottom.size(); ++k)
        sill = joined(sill, lines.bottom[k]);
    const Polyline shoulder = joined(joined(lines.fender, lines.belt), lines.rear);
    GridPatch flank = coonsPatch(sill, shoulder, lines.noseCorner, lines.tailCorner);
    flank.points = mapped(flank.points, [&](const Vec3 &p) { return lines.onSide(p); });
    addFaceBoth(builder, "flank", flank);

    // The underside: one flat floor, or floor pieces and the tunnels of the arches.
    const std::array<const char *, 5> names{"front lip", "front arch", "floor", "rear arch", "rear lip"};
    int floor = -1;
    Polyline begin = noseFoot;
    for (std::size_t k = 0; k < lines.bottom.size(); ++k) {
        const Polyline end = k == 4 ? tailFoot : CarLines::across(lines.bottom[k].back(), Vec3::Zero());
        if (floor < 0 || shape.cutArches)
            floor = builder.addFace(shape.cutArches ? names[k] : "floor");
        builder.addGrid(floor, acrossPanel(begin, end, lines.bottom[k]));
        begin = end;
    }

    addBoth(builder, "shoulder line", CurveKind::Border, shoulder);
    if (shape.cutArches)
        for (std::size_t k = 0; k < lines.bottom.size(); ++k)
            addBoth(builder, names[k], CurveKind::Border, lines.bottom[k]);
    else
        addBoth(builder, "sill", CurveKind::Border, sill);
    addBoth(builder, "nose corner", CurveKind::Border, lines.noseCorner);
    addBoth(builder, "tail corner", CurveKind::Border, lines.tailCorner);
    addBoth(builder, "front pillar", CurveKind::Border, lines.frontPillar);
    addBoth(builder, "rear pillar", CurveKind::Border, lines.rearPillar);
    addBoth(builder, "roof rail", CurveKind::Border, lines.roofRail);
    builder.addCurve("nose foot", CurveKind::Border, noseFoot);
    builder.addCurve("nose edge", CurveKind::Border, noseEdge);
    builder.addCurve("cowl", CurveKind::Border, cowl);
    builder.addCurve("front header", CurveKind::Border, frontHeader);
    builder.addCurve("rear header", CurveKind::Border, rearHeader);
    builder.addCurve("boot front", CurveKind::Border, bootFront);
    builder.addCurve("tail edge", CurveKind::Border, tailEdge);
    builder.addCurve("tail foot", CurveKind::Border, tailFoot);

    // Profile in the mirror plane, cross-sections, waist line.
    const int middle = acrossCells / 2;
    builder.addCurve("nose profile", CurveKind::Flow, nose.column(middle));
    builder.addCurve("hood profile", CurveKind::Flow, hood.column(middle));
    builder.addCurve("windscreen profile", CurveKind::Flow, windscreen.column(middle));
    builder.addCurve("roof profile", CurveKind::Flow, roof.column(middle));
    builder.addCurve("rear window profile", CurveKind::Flow, rearWindow.column(middle));
    builder.addCurve("boot profile", CurveKind::Flow, boot.column(middle));
    builder.addCurve("tail profile", CurveKind::Flow, tail.column(middle));
    builder.addCurve("hood section", CurveKind::Flow, hood.row(hood.rows / 2));
    builder.addCurve("roof section", CurveKind::Flow, roof.row(roof.rows / 2));
    builder.addCurve("bumper", CurveKind::Flow, nose.row(nose.rows / 3));
    builder.addCurve("rear bumper", CurveKind::Flow, tail.row(tail.rows / 3));
    addBoth(builder, "hood crease", CurveKind::Flow, drawnOn(hood, straightUv(0.22, 0.02, 0.16, 0.98)));
    addBoth(builder, "waist line", CurveKind::Flow,
            mapped(splinePoints({Vec3(1.98 * shape.length, 0.53, 0), Vec3(0.8 * shape.length, 0.69, 0),
                                 Vec3(-1.0 * shape.length, 0.73, 0), Vec3(-2.04 * shape.length, 0.70, 0)},
                                80),
                   [&](const Vec3 &p) { return lines.onSide(p); }));

    // What makes it a car: arches and wheels, doors, lamps, grille, number plate.
    const auto onFlank = [&](double x, double y) { return lines.onSide(Vec3(x * shape.length, y, 0)); };
    for (const Vec3 &wheel : lines.wheels) {
        if (shape.cutArches)
            break;
        const auto arc = [&](double radius, double from, double to) {
            Polyline line;
            for (int i = 0; i <= 64; ++i) {
                const double a = std::numbers::pi * (from + (to - from) * i / 64.0);
                line.push_back(lines.onSide(wheel + radius * Vec3(std::cos(a), std::sin(a), 0)));
            }
            return line;
        };
        const double dip = std::asin(0.05 / CarLines::archRadius) / std::numbers::pi;
        addBoth(builder, "wheel arch", CurveKind::Detail, arc(CarLines::archRadius, -dip, 1.0 + dip));
        addBoth(builder, "tyre", CurveKind::Detail, arc(CarLines::archRadius - 0.075, -0.06, 1.06));
    }
    Polyline frontDoor, rearDoor;
    for (const auto &[x, y] : {std::pair{0.86, 0.88}, {0.83, 0.6}, {0.78, 0.3}, {0.3, 0.29}, {-0.18, 0.29}})
        frontDoor.push_back(onFlank(x, y));
    for (const auto &[x, y] :
         {std::pair{-0.21, 0.31}, {-0.7, 0.31}, {-0.86, 0.4}, {-0.93, 0.65}, {-1.05, 0.93}})
        rearDoor.push_back(onFlank(x, y));
    const auto onSideAgain = [&](const Vec3 &p) { return lines.onSide(p); };
    addBoth(builder, "front door", CurveKind::Detail, mapped(splinePoints(frontDoor, 60), onSideAgain));
    addBoth(builder, "rear door", CurveKind::Detail, mapped(splinePoints(rearDoor, 60), onSideAgain));
    addBoth(builder, "door gap", CurveKind::Detail,
            mapped(linePoints(onFlank(-0.2, 0.92), onFlank(-0.2, 0.3), 40), onSideAgain));
    addBoth(builder, "middle pillar", CurveKind::Flow, drawnOn(windows, straightUv(0.51, 0.0, 0.50, 1.0)));
    addBoth(builder, "quarter light", CurveKind::Detail,
            drawnOn(windows, straightUv(0.83, 0.02, 0.84, 0.96)));
    addBoth(builder, "front handle", CurveKind::Detail,
            mapped(linePoints(onFlank(0.06, 0.80), onFlank(-0.12, 0.81), 16), onSideAgain));
    addBoth(builder, "rear handle", CurveKind::Detail,
            mapped(linePoints(onFlank(-0.72, 0.82), onFlank(-0.9, 0.83), 16), onSideAgain));
    addBoth(builder, "headlamp", CurveKind::Detail, drawnOn(nose, parameterEllipse(0.15, 0.76, 0.085, 0.14)));
    addBoth(builder, "tail lamp", CurveKind::Detail, drawnOn(tail, parameterRectangle(0.05, 0.68, 0.2, 0.9)));
    builder.addCurve("grille", CurveKind::Detail, drawnOn(nose, parameterRectangle(0.3, 0.56, 0.7, 0.9)));
    builder.addCurve("grille bar", CurveKind::Detail, drawnOn(nose, straightUv(0.31, 0.73, 0.69, 0.73)));
    builder.addCurve("number plate", CurveKind::Detail,
                     drawnOn(tail, parameterRectangle(0.4, 0.5, 0.6, 0.68)));
    return builder.finish(MirrorPlane{Vec3::UnitZ(), 0.0});
}

} // namespace ductus
