#include "surfacing/parts/skeletal_strokes.h"

#include <algorithm>

namespace ductus {

namespace {

enum class Side { Kept, Other, Both };

Side sideOf(const Stroke &stroke, const SymmetryPlane &plane, double tolerance)
{
    double least = 1e300, most = -1e300;
    for (const Vec3 &p : stroke.points) {
        least = std::min(least, plane.signedDistance(p));
        most = std::max(most, plane.signedDistance(p));
    }
    if (least < -tolerance)
        return most > tolerance ? Side::Both : Side::Other;
    return most > tolerance ? Side::Kept : Side::Both; // in the plane: its own mirror image
}

std::vector<double> radiiOf(const Stroke &stroke, double radius, double leastPressure)
{
    std::vector<double> radii(stroke.points.size(), radius);
    if (stroke.pressure.size() == stroke.points.size())
        for (std::size_t i = 0; i < radii.size(); ++i)
            radii[i] *= 2.0 * std::clamp(stroke.pressure[i], leastPressure, 1.0);
    return radii;
}

void append(const TriangleMesh &mesh, StrokeId stroke, SkeletalTubes &tubes)
{
    const int first = tubes.mesh.vertexCount();
    tubes.mesh.vertices.insert(tubes.mesh.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const Triangle &t : mesh.triangles)
        tubes.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    tubes.triangleTubes.resize(tubes.mesh.triangles.size(), int(tubes.tubes.size()));
    tubes.tubes.push_back(stroke);
}

TriangleMesh mirrored(TriangleMesh mesh, const SymmetryPlane &plane)
{
    for (Vec3 &v : mesh.vertices)
        v = plane.mirrored(v);
    for (Triangle &t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
}

} // namespace

SkeletalTubes skeletalTubes(const StrokeSet &strokes, double diagonal,
                            const std::optional<SymmetryPlane> &plane, const SkeletalOptions &options)
{
    SkeletalTubes tubes;
    const double radius = options.radius * diagonal;
    for (const Stroke &stroke : strokes.strokes) {
        if (stroke.role != StrokeRole::Skeletal)
            continue;
        const Side side = plane ? sideOf(stroke, *plane, radius) : Side::Both;
        if (side == Side::Other)
            continue;
        const Result<TriangleMesh> tube =
            sweptTube(stroke.points, radiiOf(stroke, radius, options.leastPressure), options.tube);
        if (!tube) {
            tubes.warnings.push_back("The skeletal stroke " + std::to_string(stroke.id.value) +
                                     " gives no tube: " + tube.error().problem + ".");
            continue;
        }
        append(*tube, stroke.id, tubes);
        if (side == Side::Kept)
            append(mirrored(*tube, *plane), stroke.id, tubes);
    }
    return tubes;
}

} // namespace ductus
