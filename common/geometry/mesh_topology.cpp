#include "geometry/mesh_topology.h"

#include <algorithm>
#include <numeric>

namespace ductus {

namespace {

bool hasRepeatedCorner(const Triangle &t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Side \a k of triangle \a face, to be sorted so that equal edges come together.
struct HalfEdge
{
    int v0;
    int v1;
    int face;
    int side;

    bool operator<(const HalfEdge &o) const
    {
        if (v0 != o.v0)
            return v0 < o.v0;
        if (v1 != o.v1)
            return v1 < o.v1;
        return face < o.face;
    }
};

std::vector<HalfEdge> sortedHalfEdges(const TriangleMesh &mesh)
{
    std::vector<HalfEdge> halfEdges;
    halfEdges.reserve(3 * mesh.triangles.size());
    for (int f = 0; f < mesh.triangleCount(); ++f) {
        const Triangle &t = mesh.triangles[f];
        if (hasRepeatedCorner(t))
            continue;
        for (int k = 0; k < 3; ++k) {
            const int a = t[k];
            const int b = t[(k + 1) % 3];
            halfEdges.push_back({std::min(a, b), std::max(a, b), f, k});
        }
    }
    std::sort(halfEdges.begin(), halfEdges.end());
    return halfEdges;
}

/// The side of \a t that runs from \a a to \a b, or -1 (also when it runs from b to a).
int sideFrom(const Triangle &t, int a, int b)
{
    for (int k = 0; k < 3; ++k)
        if (t[k] == a && t[(k + 1) % 3] == b)
            return k;
    return -1;
}

int root(std::vector<int> &parent, int i)
{
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

/// Vertices whose triangles, joined across the edges they share there, form more than one fan, or one that
/// branches.
int countNonManifoldVertices(const TriangleMesh &mesh, const MeshTopology &topology)
{
    int count = 0;
    std::vector<int> parent(mesh.triangles.size());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const std::vector<int> &faces = topology.vertexFaces[v];
        if (faces.empty())
            continue;
        for (int f : faces)
            parent[f] = f;
        int fans = int(faces.size());
        bool branches = false;
        for (int e : topology.vertexEdges[v]) {
            const MeshEdge &edge = topology.edges[e];
            branches = branches || edge.faceCount > 2;
            if (edge.faceCount < 2)
                continue;
            const int a = root(parent, edge.faces[0]);
            const int b = root(parent, edge.faces[1]);
            if (a != b) {
                parent[a] = b;
                --fans;
            }
        }
        count += fans > 1 || branches ? 1 : 0;
    }
    return count;
}

} // namespace

MeshTopology::MeshTopology(const TriangleMesh &mesh)
    : faceEdges(mesh.triangles.size(), {-1, -1, -1}), vertexEdges(mesh.vertices.size()),
      vertexFaces(mesh.vertices.size())
{
    edges.reserve(3 * mesh.triangles.size() / 2 + 16);
    for (const HalfEdge &h : sortedHalfEdges(mesh)) {
        if (edges.empty() || edges.back().v0 != h.v0 || edges.back().v1 != h.v1) {
            MeshEdge edge;
            edge.v0 = h.v0;
            edge.v1 = h.v1;
            edges.push_back(edge);
        }
        MeshEdge &edge = edges.back();
        if (edge.faceCount < 2)
            edge.faces[edge.faceCount] = h.face;
        ++edge.faceCount;
        faceEdges[h.face][h.side] = int(edges.size()) - 1;
    }
    for (int e = 0; e < int(edges.size()); ++e) {
        vertexEdges[edges[e].v0].push_back(e);
        vertexEdges[edges[e].v1].push_back(e);
    }
    for (int f = 0; f < mesh.triangleCount(); ++f)
        if (!hasRepeatedCorner(mesh.triangles[f]))
            for (int v : mesh.triangles[f])
                vertexFaces[v].push_back(f);
}

int MeshTopology::edgeBetween(int a, int b) const
{
    const int v0 = std::min(a, b);
    const int v1 = std::max(a, b);
    const auto at = std::lower_bound(edges.begin(), edges.end(), v0, [v1](const MeshEdge &e, int first) {
        return e.v0 != first ? e.v0 < first : e.v1 < v1;
    });
    return at != edges.end() && at->v0 == v0 && at->v1 == v1 ? int(at - edges.begin()) : -1;
}

std::vector<char> MeshTopology::borderVertices() const
{
    std::vector<char> border(vertexEdges.size(), 0);
    for (const MeshEdge &edge : edges)
        if (edge.faceCount == 1)
            border[edge.v0] = border[edge.v1] = 1;
    return border;
}

ManifoldReport manifoldReport(const TriangleMesh &mesh)
{
    const MeshTopology topology(mesh);
    ManifoldReport report;
    for (int f = 0; f < mesh.triangleCount(); ++f)
        if (hasRepeatedCorner(mesh.triangles[f]) || !(mesh.areaVector(f).squaredNorm() > 0.0))
            ++report.degenerateTriangles;
    for (const MeshEdge &edge : topology.edges) {
        if (edge.faceCount == 1) {
            ++report.borderEdges;
        } else if (edge.faceCount > 2) {
            ++report.nonManifoldEdges;
        } else {
            const bool forward0 = sideFrom(mesh.triangles[edge.faces[0]], edge.v0, edge.v1) >= 0;
            const bool forward1 = sideFrom(mesh.triangles[edge.faces[1]], edge.v0, edge.v1) >= 0;
            report.inconsistentEdges += forward0 == forward1 ? 1 : 0;
        }
    }
    report.nonManifoldVertices = countNonManifoldVertices(mesh, topology);
    triangleComponents(topology, &report.components);
    return report;
}

std::vector<int> triangleComponents(const MeshTopology &topology, int *count)
{
    const int faceCount = int(topology.faceEdges.size());
    std::vector<int> parent(faceCount);
    std::iota(parent.begin(), parent.end(), 0);
    // Not by MeshEdge::faces, which forgets the third and later triangles of an edge.
    std::vector<int> firstFace(topology.edges.size(), -1);
    for (int f = 0; f < faceCount; ++f) {
        for (int e : topology.faceEdges[f]) {
            if (e < 0)
                continue;
            if (firstFace[e] < 0)
                firstFace[e] = f;
            else
                parent[root(parent, f)] = root(parent, firstFace[e]);
        }
    }
    std::vector<int> numberOfRoot(faceCount, -1);
    std::vector<int> component(faceCount);
    int next = 0;
    for (int f = 0; f < faceCount; ++f) {
        int &number = numberOfRoot[root(parent, f)];
        if (number < 0)
            number = next++;
        component[f] = number;
    }
    if (count)
        *count = next;
    return component;
}

} // namespace ductus
