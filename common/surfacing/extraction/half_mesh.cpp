#include "surfacing/extraction/half_mesh.h"

#include <cmath>

namespace ductus {

TriangleMesh keptHalf(const TriangleMesh &mesh, const SymmetryPlane &plane)
{
    const MeshTopology topology(mesh);
    std::vector<int> side(mesh.vertices.size());
    for (std::size_t v = 0; v < side.size(); ++v)
        side[v] = plane.signedDistance(mesh.vertices[v]) >= 0.0 ? 0 : 1;
    std::vector<double> positions(topology.edges.size(), 0.5);
    for (std::size_t e = 0; e < positions.size(); ++e) {
        const double a = plane.signedDistance(mesh.vertices[std::size_t(topology.edges[e].v0)]);
        const double b = plane.signedDistance(mesh.vertices[std::size_t(topology.edges[e].v1)]);
        if (a != b)
            positions[e] = a / (a - b);
    }
    SeamedMesh seamed = insertSeams(mesh, topology, side, positions);
    // insertSeams keeps triangles fat by moving cuts a little along their edges; the border belongs in the plane.
    for (std::size_t v = mesh.vertices.size(); v < seamed.mesh.vertices.size(); ++v)
        seamed.mesh.vertices[v] = plane.projected(seamed.mesh.vertices[v]);
    TriangleMesh half = seamed.mesh;
    half.triangles.clear();
    for (std::size_t t = 0; t < seamed.mesh.triangles.size(); ++t)
        if (seamed.triangleLabels[t] == 0)
            half.triangles.push_back(seamed.mesh.triangles[t]);
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
