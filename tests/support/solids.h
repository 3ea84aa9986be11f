// Exact piecewise-smooth shapes to draw synthetic sketches from: a fine mesh that knows the smooth face every
// triangle belongs to, and the curves a designer would draw of it. All lengths in the shape's own unit (about
// one metre), Y up.
#pragma once

#include "geometry/triangle_mesh.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ductus {

/// Points x with normal . x == offset; normal is a unit vector.
struct MirrorPlane
{
    Vec3 normal = Vec3::UnitZ();
    double offset = 0.0;

    Vec3 mirrored(const Vec3 &point) const { return point - 2.0 * (normal.dot(point) - offset) * normal; }
    double signedDistance(const Vec3 &point) const { return normal.dot(point) - offset; }
};

enum class CurveKind {
    Border,   // between two faces; sharp or smooth, see FeatureCurve::sharp
    Flow,     // smooth characteristic curve: cross-section, profile, flow line
    Boundary, // where an open shell ends
    Detail,   // drawn on a face for its own sake: a door, a headlight
};

struct FeatureCurve
{
    std::string name;
    CurveKind kind = CurveKind::Flow;
    std::vector<Vec3> points; // fine; a closed curve repeats its first point at the end
    std::vector<char> sharp;  // one a point: 1 where an edge of the mesh with a dihedral angle above
                              // Solid::sharpDegrees runs along the curve

    bool isClosed() const;
};

struct Solid
{
    static constexpr double sharpDegrees =
        30.0; // 10 more than what counts as a crease in a result (evaluation.h)

    std::string id;
    TriangleMesh mesh;              // manifold; outwards oriented where closed
    std::vector<int> triangleFaces; // smooth face of each triangle, 0 .. faceNames.size()-1
    std::vector<std::string> faceNames;
    std::vector<FeatureCurve> curves;
    std::optional<MirrorPlane> mirror;
    bool isOpen = false;

    int faceCount() const { return int(faceNames.size()); }
    double diagonal() const { return boundingBox(mesh.vertices).diagonal(); }
};

/// Car bodies: the wheel arches are drawn on flat sides, or cut through the body from side to side.
struct CarShape
{
    bool cutArches = false;
    double length = 1.0; // scale of the whole car along its length, 1 = 0.86 m
    double height = 1.0; // scale of the cabin above the belt line
};

Solid bevelledBox(double width = 0.5, double height = 0.3, double depth = 0.36, double bevel = 0.06);
Solid can(double radius = 0.17, double height = 0.46);
Solid bottle(double bodyRadius = 0.115, double height = 0.55);
Solid tableLamp(double height = 0.62);
Solid torus(double majorRadius = 0.24, double minorRadius = 0.09);
Solid ellipsoid(const Vec3 &radii = Vec3(0.32, 0.2, 0.24));
Solid lBracket(double size = 0.4, double thickness = 0.1, double depth = 0.24);
Solid house(double width = 0.36, double wallHeight = 0.22, double roofHeight = 0.17, double length = 0.48);
Solid saddle(double size = 0.5, double rise = 0.12);
Solid bentLeaf(double length = 0.6, double foldSlope = 0.45);
Solid computerMouse(double length = 0.46);
Solid car(const CarShape &shape = {});
Solid iron(double length = 0.5);

struct SolidEntry
{
    std::string id; // equals Solid::id
    std::function<Solid()> make;
};

/// Every shape with its default measures, and the car also with cut arches, in a fixed order.
const std::vector<SolidEntry> &allSolids();

} // namespace ductus
