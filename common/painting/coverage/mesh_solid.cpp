#include "painting/coverage/mesh_solid.h"

#include "geometry/triangle_point.h"

#include <limits>

namespace ductus {

namespace {

/// [Moeller, Trumbore 1997], two-sided.
bool hitTriangle(const Vec3 &a, const Vec3 &b, const Vec3 &c, const Vec3 &origin, const Vec3 &direction,
                 MeshHit &hit)
{
    const Vec3 e1 = b - a, e2 = c - a, cross = direction.cross(e2);
    const double det = e1.dot(cross);
    if (det == 0)
        return false;
    const Vec3 from = origin - a, other = from.cross(e1);
    const double u = from.dot(cross) / det, v = direction.dot(other) / det;
    constexpr double edge = -1e-9; // no pinholes between neighbours
    if (u < edge || v < edge || u + v > 1 - edge)
        return false;
    hit.s = e2.dot(other) / det;
    hit.barycentric = Vec3(1 - u - v, u, v);
    return true;
}

} // namespace

MeshSolid::MeshSolid(const MeshShape &shape, const Eigen::Affine3d &sceneFromElement)
    : mMesh(shape.mesh), mColours(shape.vertexColours)
{
    for (Vec3 &vertex : mMesh.vertices)
        vertex = sceneFromElement * vertex;
    std::vector<Box3> boxes(mMesh.triangles.size());
    for (std::size_t t = 0; t < boxes.size(); ++t)
        for (const int vertex : mMesh.triangles[t]) {
            boxes[t].add(mMesh.vertices[std::size_t(vertex)]);
            mBox.add(mMesh.vertices[std::size_t(vertex)]);
        }
    mTree = BoxTree(boxes);
    for (const Eigen::Vector3f &colour : mColours)
        mMeanColour += colour / float(mColours.size());
}

std::optional<MeshHit> MeshSolid::hit(const Vec3 &origin, const Vec3 &direction, double from,
                                      double limit) const
{
    std::optional<MeshHit> nearest;
    mTree.forRay(origin, direction, limit, [&](int t) {
        const Triangle &triangle = mMesh.triangles[std::size_t(t)];
        MeshHit hit;
        if (hitTriangle(mMesh.vertices[std::size_t(triangle[0])], mMesh.vertices[std::size_t(triangle[1])],
                        mMesh.vertices[std::size_t(triangle[2])], origin, direction, hit) &&
            hit.s >= from && hit.s < limit) {
            hit.triangle = t;
            nearest = hit;
            limit = hit.s;
        }
        return limit;
    });
    return nearest;
}

bool MeshSolid::contains(const Vec3 &x) const
{
    // A ray may slip along an edge: three of them vote.
    static const std::array<Vec3, 3> directions{Vec3(0.5377, 0.3129, 0.7829), Vec3(-0.2733, 0.8841, 0.3791),
                                                Vec3(0.6413, -0.5119, -0.5717)};
    int votes = 0;
    for (const Vec3 &direction : directions) {
        int winding = 0;
        const double everything = std::numeric_limits<double>::infinity();
        mTree.forRay(x, direction, everything, [&](int t) {
            const Triangle &triangle = mMesh.triangles[std::size_t(t)];
            MeshHit hit;
            if (hitTriangle(mMesh.vertices[std::size_t(triangle[0])],
                            mMesh.vertices[std::size_t(triangle[1])],
                            mMesh.vertices[std::size_t(triangle[2])], x, direction, hit) &&
                hit.s >= 0)
                winding += mMesh.areaVector(t).dot(direction) > 0 ? 1 : -1;
            return everything;
        });
        votes += winding != 0;
    }
    return votes >= 2;
}

std::optional<MeshHit> MeshSolid::nearest(const Vec3 &x, double limit) const
{
    std::optional<MeshHit> nearest;
    mTree.forNear(x, limit, [&](int t) {
        const Triangle &triangle = mMesh.triangles[std::size_t(t)];
        const Vec3 &a = mMesh.vertices[std::size_t(triangle[0])];
        const Vec3 &b = mMesh.vertices[std::size_t(triangle[1])];
        const Vec3 &c = mMesh.vertices[std::size_t(triangle[2])];
        if (mMesh.areaVector(t).isZero())
            return limit;
        const Vec3 w = nearestBarycentric(x, a, b, c);
        const double distance = (w[0] * a + w[1] * b + w[2] * c - x).norm();
        if (distance <= limit && (!nearest || distance < nearest->s)) {
            nearest = MeshHit{distance, t, w};
            limit = distance;
        }
        return limit;
    });
    return nearest;
}

Vec3 MeshSolid::point(const MeshHit &hit) const
{
    const Triangle &t = mMesh.triangles[std::size_t(hit.triangle)];
    return hit.barycentric[0] * mMesh.vertices[std::size_t(t[0])] +
           hit.barycentric[1] * mMesh.vertices[std::size_t(t[1])] +
           hit.barycentric[2] * mMesh.vertices[std::size_t(t[2])];
}

Eigen::Vector3f MeshSolid::colour(const MeshHit &hit) const
{
    const Triangle &t = mMesh.triangles[std::size_t(hit.triangle)];
    const Eigen::Vector3f w = hit.barycentric.cast<float>();
    const Eigen::Vector3f mixed = w[0] * mColours[std::size_t(t[0])] + w[1] * mColours[std::size_t(t[1])] +
                                  w[2] * mColours[std::size_t(t[2])];
    return mixed.cwiseMax(0).cwiseMin(1); // rounding
}

} // namespace ductus
