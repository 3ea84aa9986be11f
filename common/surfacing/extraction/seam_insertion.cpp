#include "surfacing/extraction/seam_insertion.h"

#include <algorithm>
#include <set>

namespace ductus {

SeamedMesh insertSeams(const TriangleMesh &mesh, const MeshTopology &topology, const std::vector<int> &labels,
                       const std::vector<double> &cutPositions)
{
    SeamedMesh result;
    result.mesh.vertices = mesh.vertices;
    for (int label : labels)
        result.vertexLabels.push_back({label});

    std::vector<int> cutVertex(topology.edges.size(), -1);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const int a = topology.edges[e].v0, b = topology.edges[e].v1;
        const int la = labels[std::size_t(a)], lb = labels[std::size_t(b)];
        if (la == lb)
            continue;
        const double t = std::clamp(cutPositions[e], 0.2, 0.8);
        cutVertex[e] = result.mesh.vertexCount();
        result.mesh.vertices.push_back((1.0 - t) * mesh.vertices[std::size_t(a)] + t * mesh.vertices[std::size_t(b)]);
        result.vertexLabels.push_back({std::min(la, lb), std::max(la, lb)});
    }

    const auto add = [&](int a, int b, int c, int label) {
        result.mesh.triangles.push_back({a, b, c});
        result.triangleLabels.push_back(label);
    };
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Triangle &corners = mesh.triangles[std::size_t(t)];
        int cut[3];
        int cuts = 0;
        for (int k = 0; k < 3; ++k) {
            cut[k] = cutVertex[std::size_t(topology.faceEdges[std::size_t(t)][std::size_t(k)])];
            cuts += cut[k] >= 0;
        }
        const auto label = [&](int k) { return labels[std::size_t(corners[std::size_t(k)])]; };
        if (cuts == 0) {
            add(corners[0], corners[1], corners[2], label(0));
        } else if (cuts == 2) {
            int lone = 0; // the corner whose label differs from the other two
            while (label((lone + 1) % 3) != label((lone + 2) % 3))
                ++lone;
            const int a = corners[std::size_t(lone)], b = corners[std::size_t((lone + 1) % 3)],
                      c = corners[std::size_t((lone + 2) % 3)];
            const int ab = cut[lone], ca = cut[(lone + 2) % 3];
            add(a, ab, ca, label(lone));
            // The shorter diagonal of the remaining quadrilateral ab, b, c, ca.
            const auto &v = result.mesh.vertices;
            if ((v[std::size_t(ab)] - v[std::size_t(c)]).squaredNorm() <
                (v[std::size_t(b)] - v[std::size_t(ca)]).squaredNorm()) {
                add(ab, b, c, label((lone + 1) % 3));
                add(ab, c, ca, label((lone + 1) % 3));
            } else {
                add(ab, b, ca, label((lone + 1) % 3));
                add(b, c, ca, label((lone + 1) % 3));
            }
        } else {
            const int centre = result.mesh.vertexCount();
            result.mesh.vertices.push_back((result.mesh.vertices[std::size_t(cut[0])] +
                                            result.mesh.vertices[std::size_t(cut[1])] +
                                            result.mesh.vertices[std::size_t(cut[2])]) /
                                           3.0);
            std::vector<int> three{label(0), label(1), label(2)};
            std::sort(three.begin(), three.end());
            result.vertexLabels.push_back(three);
            for (int k = 0; k < 3; ++k) {
                add(corners[std::size_t(k)], cut[k], centre, label(k));
                add(corners[std::size_t(k)], centre, cut[(k + 2) % 3], label(k));
            }
        }
    }

    const MeshTopology seamed(result.mesh);
    for (const MeshEdge &edge : seamed.edges)
        if (edge.faceCount == 2 && result.triangleLabels[std::size_t(edge.faces[0])] !=
                                       result.triangleLabels[std::size_t(edge.faces[1])])
            result.seamEdges.emplace_back(edge.v0, edge.v1);
    return result;
}

} // namespace ductus
