#include "surfacing/extraction/half_mesh.h"

#include <cmath>

namespace ductus {

TriangleMesh keptHalf(const TriangleMesh &mesh, const SymmetryPlane &plane)
{
    const MeshTopology topology(mesh);
    TriangleMesh half;
    half.vertices = mesh.vertices;
    // Vertices nearly in the plane are put into it: cutting beside them would leave slivers.
    const double tolerance = 0.1 * meanEdgeLength(mesh);
    std::vector<int> side(mesh.vertices.size());
    for (std::size_t v = 0; v < side.size(); ++v) {
        const double distance = plane.signedDistance(mesh.vertices[v]);
        side[v] = distance > tolerance ? 1 : distance < -tolerance ? -1 : 0;
        if (side[v] == 0)
            half.vertices[v] = plane.projected(mesh.vertices[v]);
    }
    std::vector<int> cutVertex(topology.edges.size(), -1);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const std::size_t v0 = std::size_t(topology.edges[e].v0), v1 = std::size_t(topology.edges[e].v1);
        if (side[v0] * side[v1] >= 0)
            continue;
        const double d0 = plane.signedDistance(mesh.vertices[v0]), d1 = plane.signedDistance(mesh.vertices[v1]);
        cutVertex[e] = half.vertexCount();
        half.vertices.push_back(plane.projected(mesh.vertices[v0] + d0 / (d0 - d1) * (mesh.vertices[v1] - mesh.vertices[v0])));
    }
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Triangle &corners = mesh.triangles[std::size_t(t)];
        std::vector<int> polygon;
        bool reachesIn = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t v = std::size_t(corners[k]);
            if (side[v] >= 0)
                polygon.push_back(corners[k]);
            reachesIn = reachesIn || side[v] > 0;
            const int cut = cutVertex[std::size_t(topology.faceEdges[std::size_t(t)][k])];
            if (cut >= 0)
                polygon.push_back(cut);
        }
        for (std::size_t k = 2; reachesIn && k < polygon.size(); ++k)
            half.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
    }
    return compacted(half);
}

std::vector<char> verticesInPlane(const TriangleMesh &mesh, const SymmetryPlane &plane)
{
    std::vector<char> flags = MeshTopology(mesh).borderVertices();
    for (std::size_t v = 0; v < flags.size(); ++v)
        flags[v] = flags[v] && std::abs(plane.signedDistance(mesh.vertices[v])) < 1e-9;
    return flags;
}

MirroredMesh withMirrorImage(const TriangleMesh &half, const SymmetryPlane &plane, const std::vector<char> &inPlane)
{
    MirroredMesh result{half, {}};
    for (std::size_t v = 0; v < half.vertices.size(); ++v) {
        if (inPlane[v]) {
            result.mesh.vertices[v] = plane.projected(half.vertices[v]);
            result.imageOfVertex.push_back(int(v));
        } else {
            result.imageOfVertex.push_back(result.mesh.vertexCount());
            result.mesh.vertices.push_back(plane.mirrored(half.vertices[v]));
        }
    }
    for (const Triangle &t : half.triangles)
        result.mesh.triangles.push_back({result.imageOfVertex[std::size_t(t[0])],
                                         result.imageOfVertex[std::size_t(t[2])],
                                         result.imageOfVertex[std::size_t(t[1])]});
    return result;
}

} // namespace ductus
