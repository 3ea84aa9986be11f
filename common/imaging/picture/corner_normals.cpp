#include "imaging/picture/corner_normals.h"

#include "base/parallel.h"
#include "geometry/mesh_topology.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus::picture {

namespace {

double cosineOfDegrees(double degrees)
{
    return std::cos(std::clamp(degrees, 0.0, 180.0) * std::numbers::pi / 180.0);
}

// The mesh's own normals, but scale-free: a triangle of a micrometre has one, too.
std::vector<Vec3> faceNormals(const TriangleMesh &mesh)
{
    std::vector<Vec3> normals(mesh.triangles.size(), Vec3::Zero());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Triangle &c = mesh.triangles[std::size_t(t)];
        const Vec3 u = mesh.vertices[std::size_t(c[1])] - mesh.vertices[std::size_t(c[0])];
        const Vec3 v = mesh.vertices[std::size_t(c[2])] - mesh.vertices[std::size_t(c[0])];
        const Vec3 n = u.stableNormalized().cross(v.stableNormalized());
        if (n.norm() > 1e-12)
            normals[std::size_t(t)] = n.normalized();
    }
    return normals;
}

double cornerAngle(const TriangleMesh &mesh, int triangle, int corner)
{
    const Triangle &c = mesh.triangles[std::size_t(triangle)];
    const Vec3 &p = mesh.vertices[std::size_t(c[std::size_t(corner)])];
    const Vec3 u = mesh.vertices[std::size_t(c[std::size_t((corner + 1) % 3)])] - p;
    const Vec3 v = mesh.vertices[std::size_t(c[std::size_t((corner + 2) % 3)])] - p;
    return std::atan2(u.cross(v).norm(), u.dot(v));
}

// Corners (3 * triangle + k) grouped by vertex: those of vertex v are at begin[v] .. begin[v + 1].
struct CornersOfVertices
{
    std::vector<std::size_t> begin;
    std::vector<int> corners;

    explicit CornersOfVertices(const TriangleMesh &mesh)
        : begin(mesh.vertices.size() + 1, 0), corners(mesh.triangles.size() * 3)
    {
        for (const Triangle &triangle : mesh.triangles) {
            for (int v : triangle)
                ++begin[std::size_t(v) + 1];
        }
        for (std::size_t v = 1; v < begin.size(); ++v)
            begin[v] += begin[v - 1];
        std::vector<std::size_t> next = begin;
        for (int t = 0; t < mesh.triangleCount(); ++t) {
            for (int k = 0; k < 3; ++k)
                corners[next[std::size_t(mesh.triangles[std::size_t(t)][std::size_t(k)])]++] = 3 * t + k;
        }
    }
};

} // namespace

CornerNormals cornerNormals(const TriangleMesh &mesh, double creaseAngleDegrees)
{
    CornerNormals result;
    result.faces = faceNormals(mesh);
    result.corners.resize(mesh.triangles.size());
    if (creaseAngleDegrees <= 0.0) {
        for (std::size_t t = 0; t < result.corners.size(); ++t)
            result.corners[t].fill(result.faces[t]);
        return result;
    }
    const double cosine = cosineOfDegrees(creaseAngleDegrees);
    const CornersOfVertices around(mesh);
    parallelFor(
        0, mesh.triangles.size(),
        [&](std::size_t t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto vertex = std::size_t(mesh.triangles[t][k]);
                Vec3 sum = Vec3::Zero();
                for (std::size_t i = around.begin[vertex]; i < around.begin[vertex + 1]; ++i) {
                    const int corner = around.corners[i];
                    const Vec3 &normal = result.faces[std::size_t(corner / 3)];
                    if (normal.dot(result.faces[t]) >= cosine)
                        sum += cornerAngle(mesh, corner / 3, corner % 3) * normal;
                }
                const double length = sum.norm();
                result.corners[t][k] = length > 1e-12 ? Vec3(sum / length) : result.faces[t];
            }
        },
        256);
    return result;
}

std::vector<std::pair<int, int>> creaseEdges(const TriangleMesh &mesh, double creaseAngleDegrees,
                                             const std::function<bool(int, int)> &differ)
{
    const double cosine = cosineOfDegrees(creaseAngleDegrees);
    const std::vector<Vec3> normals = faceNormals(mesh);
    const MeshTopology topology(mesh);
    std::vector<std::pair<int, int>> result;
    for (const MeshEdge &edge : topology.edges) {
        bool isCrease = edge.faceCount != 2;
        if (!isCrease) {
            const Vec3 &a = normals[std::size_t(edge.faces[0])];
            const Vec3 &b = normals[std::size_t(edge.faces[1])];
            // A triangle without area bends nothing: it has no normal to compare.
            isCrease =
                (!a.isZero() && !b.isZero() && a.dot(b) < cosine) || differ(edge.faces[0], edge.faces[1]);
        }
        if (isCrease)
            result.emplace_back(edge.v0, edge.v1);
    }
    return result;
}

} // namespace ductus::picture
