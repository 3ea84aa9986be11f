#include "surfacing/pipeline/local_attraction.h"

#include "base/parallel.h"
#include "surfacing/extraction/half_mesh.h"
#include "surfacing/proxy/least_squares_mesh.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double heldBorder = 1e3; // against the pull of strokes: the border of the part that moves stays

std::vector<double> distancesTo(const std::vector<Vec3> &targets, const std::vector<Vec3> &points)
{
    std::vector<double> distances(points.size());
    parallelFor(
        0, points.size(),
        [&](std::size_t i) {
            double nearest = 1e300;
            for (const Vec3 &target : targets)
                nearest = std::min(nearest, (points[i] - target).squaredNorm());
            distances[i] = std::sqrt(nearest);
        },
        256);
    return distances;
}

// 1 up to options.full, 0 from options.none on, smooth between.
double share(double distance, const LocalAttractionOptions &options)
{
    const double t = std::clamp((options.none - distance) / (options.none - options.full), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

Result<TriangleMesh> attractedWhole(const TriangleMesh &mesh, const std::vector<Vec3> &strokePoints,
                                    const std::vector<Vec3> &changed, const LocalAttractionOptions &options,
                                    const JobControl &control)
{
    const std::vector<double> distances = distancesTo(changed, mesh.vertices);
    TriangleMesh near{mesh.vertices, {}};
    for (const Triangle &t : mesh.triangles)
        if (std::all_of(t.begin(), t.end(), [&](int v) { return distances[std::size_t(v)] < options.none; }))
            near.triangles.push_back(t);
    if (near.isEmpty())
        return mesh;
    std::vector<int> oldFromNew;
    near = compacted(near, &oldFromNew);
    std::vector<Vec3> pulling;
    const std::vector<double> pointDistances = distancesTo(changed, strokePoints);
    for (std::size_t i = 0; i < strokePoints.size(); ++i)
        if (pointDistances[i] < options.none)
            pulling.push_back(strokePoints[i]);
    AttractionOptions attraction;
    attraction.borderAnchorWeight = heldBorder;
    attraction.maxDistance = options.maxDistance;
    attraction.rounds = 2; // the strokes are near already
    const Result<TriangleMesh> moved = attracted(near, pulling, attraction, control);
    if (!moved)
        return moved;
    TriangleMesh result = mesh;
    for (std::size_t v = 0; v < oldFromNew.size(); ++v) {
        const std::size_t old = std::size_t(oldFromNew[v]);
        result.vertices[old] += share(distances[old], options) * (moved->vertices[v] - mesh.vertices[old]);
    }
    return result;
}

} // namespace

Result<TriangleMesh> attractedNear(const TriangleMesh &proxy, const StrokeSet &strokes,
                                   const std::vector<Vec3> &changed,
                                   const std::optional<SymmetryPlane> &plane,
                                   const LocalAttractionOptions &options, const JobControl &control)
{
    // A half is moved with its mirror image, so that strokes in the plane move its border.
    TriangleMesh whole = proxy;
    std::vector<Vec3> points = strokes.allPoints(), changedPoints = changed;
    std::vector<char> inPlane;
    if (plane) {
        inPlane = verticesInPlane(proxy, *plane);
        whole = withMirrorImage(proxy, *plane, inPlane).mesh;
        points = withMirrorImage(strokes, *plane).allPoints();
        for (const Vec3 &p : changed)
            changedPoints.push_back(plane->mirrored(p));
    }
    Result<TriangleMesh> moved = attractedWhole(whole, points, changedPoints, options, control);
    if (!moved)
        return moved;
    TriangleMesh result = proxy;
    std::copy_n(moved->vertices.begin(), result.vertices.size(), result.vertices.begin());
    for (std::size_t v = 0; v < inPlane.size(); ++v)
        if (inPlane[v])
            result.vertices[v] = plane->projected(result.vertices[v]);
    for (int t = 0; t < proxy.triangleCount(); ++t)
        if (result.areaVector(t).dot(proxy.areaVector(t)) < 0.0)
            return Error{ErrorCode::NoSolution, "Moving the proxy to the changed strokes",
                         "it would fold over", "Surface the whole sketch anew", ""};
    return result;
}

} // namespace ductus
