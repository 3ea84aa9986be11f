#include "surfacing/proxy/hull_outlines.h"

#include "geometry/convex_hull.h"
#include "surfacing/proxy/outline.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

std::vector<int> greatTriangles(const TriangleMesh &hull, double leastArea)
{
    std::vector<int> triangles;
    for (int t = 0; t < hull.triangleCount(); ++t)
        if (0.5 * hull.areaVector(t).norm() > leastArea)
            triangles.push_back(t);
    std::stable_sort(triangles.begin(), triangles.end(), [&](int a, int b) {
        return hull.areaVector(a).squaredNorm() > hull.areaVector(b).squaredNorm();
    });
    return triangles;
}

std::vector<Vec3> pointsInPlane(const std::vector<std::vector<Vec3>> &drawn, const Vec3 &centre,
                                const Vec3 &normal, double tolerance)
{
    std::vector<Vec3> points;
    for (const std::vector<Vec3> &stroke : drawn)
        if (liesInPlane(stroke, centre, normal, tolerance))
            points.insert(points.end(), stroke.begin(), stroke.end());
    return points;
}

} // namespace

bool liesInPlane(const std::vector<Vec3> &stroke, const Vec3 &centre, const Vec3 &normal, double tolerance)
{
    const auto in = std::count_if(stroke.begin(), stroke.end(), [&](const Vec3 &p) {
        return std::abs(normal.dot(p - centre)) < tolerance;
    });
    return double(in) >= 0.9 * double(stroke.size());
}

std::vector<HullOutline> outlinesOnHull(const std::vector<std::vector<Vec3>> &drawn, double tolerance,
                                        double leastArea)
{
    TriangleMesh hull;
    for (const std::vector<Vec3> &stroke : drawn)
        hull.vertices.insert(hull.vertices.end(), stroke.begin(), stroke.end());
    hull.triangles = convexHull(hull.vertices);
    std::vector<HullOutline> outlines;
    std::vector<OutlinePlane> planes;
    for (const int t : greatTriangles(hull, leastArea)) {
        const Vec3 normal = hull.faceNormal(t), middle = hull.centroid(t);
        const bool isKnown = std::any_of(planes.begin(), planes.end(), [&](const OutlinePlane &plane) {
            return std::abs(plane.normal.dot(normal)) > 0.97 &&
                   std::abs(plane.height(middle)) < 2.0 * tolerance;
        });
        if (isKnown)
            continue;
        std::vector<Vec3> points = pointsInPlane(drawn, middle, normal, tolerance);
        if (points.size() < 3)
            continue;
        // The triangle touches the farthest points only; the plane through all is truer, and takes in more.
        OutlinePlane plane = planeThrough(points);
        points = pointsInPlane(drawn, plane.centre, plane.normal, tolerance);
        if (points.size() < 3)
            continue;
        plane = planeThrough(points);
        planes.push_back(plane);
        outlines.push_back(
            {std::move(points), plane.normal.dot(normal) > 0.0 ? plane.normal : -plane.normal});
    }
    return outlines;
}

} // namespace ductus
