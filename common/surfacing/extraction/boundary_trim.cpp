#include "surfacing/extraction/boundary_trim.h"

#include "numeric/alpha_expansion.h"
#include "surfacing/extraction/seam_insertion.h"

#include <algorithm>

namespace ductus {

namespace {

// Vertices within so many rings of those flagged.
std::vector<char> grown(std::vector<char> flags, const MeshTopology &topology, int rings)
{
    for (int ring = 0; ring < rings; ++ring) {
        std::vector<char> next = flags;
        for (const MeshEdge &e : topology.edges)
            if (flags[std::size_t(e.v0)] || flags[std::size_t(e.v1)])
                next[std::size_t(e.v0)] = next[std::size_t(e.v1)] = 1;
        flags = std::move(next);
    }
    return flags;
}

struct Terminals
{
    std::vector<char> inside, outside;
    std::vector<char> edgeIsBoundary; // crossed by a boundary stroke
};

Terminals terminals(const MeshTopology &topology, const Association &association, const StrokeSet &strokes,
                    const std::vector<char> &inPlane, const BoundaryTrimOptions &options)
{
    Terminals t;
    const std::size_t vertexCount = association.pointsOfVertex.size();
    t.edgeIsBoundary.assign(topology.edges.size(), 0);
    std::vector<char> nearBoundary(vertexCount, 0);
    for (const StrokeSample &sample : association.samples)
        if (strokes.strokes[std::size_t(sample.stroke)].role == StrokeRole::Boundary) {
            t.edgeIsBoundary[std::size_t(sample.edge)] = 1;
            nearBoundary[std::size_t(topology.edges[std::size_t(sample.edge)].v0)] = 1;
            nearBoundary[std::size_t(topology.edges[std::size_t(sample.edge)].v1)] = 1;
        }
    const bool isMarked = std::find(nearBoundary.begin(), nearBoundary.end(), 1) != nearBoundary.end();
    if (isMarked)
        nearBoundary = grown(nearBoundary, topology, options.clearanceRings);
    t.inside.assign(vertexCount, 0);
    for (std::size_t v = 0; v < vertexCount; ++v)
        t.inside[v] = !association.pointsOfVertex[v].empty() && !nearBoundary[v];
    t.outside = topology.borderVertices();
    for (std::size_t v = 0; v < vertexCount; ++v)
        t.outside[v] = t.outside[v] && !t.inside[v] && (inPlane.empty() || !inPlane[v]);
    return t;
}

} // namespace

Result<TriangleMesh> trimmed(const TriangleMesh &proxy, const MeshTopology &topology, const Association &association,
                             const StrokeSet &strokes, const std::vector<char> &inPlane,
                             const BoundaryTrimOptions &options, const JobControl &control)
{
    const Terminals t = terminals(topology, association, strokes, inPlane, options);
    if (std::find(t.outside.begin(), t.outside.end(), 1) == t.outside.end())
        return proxy;

    LabelingProblem cut; // label 0: inside, 1: outside
    cut.vertexCount = proxy.vertexCount();
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const MeshEdge &edge = topology.edges[e];
        const double length = (proxy.vertices[std::size_t(edge.v0)] - proxy.vertices[std::size_t(edge.v1)]).norm();
        cut.edges.push_back({edge.v0, edge.v1, t.edgeIsBoundary[e] ? length * options.crossedByBoundary : length});
    }
    double forbidden = 1.0;
    for (const LabelingEdge &e : cut.edges)
        forbidden += e.weight;
    std::vector<double> insideCosts(t.inside.size(), 0.0), outsideCosts(t.inside.size(), 0.0);
    for (std::size_t v = 0; v < t.inside.size(); ++v) {
        insideCosts[v] = t.outside[v] ? forbidden : 0.0;
        outsideCosts[v] = t.inside[v] ? forbidden : 0.0;
    }
    cut.dataCosts = {insideCosts, outsideCosts};
    cut.labelCosts = {0.0, 0.0};
    const Result<Labeling> labeling = alphaExpansion(cut, {}, std::vector<int>(t.inside.size(), 0), control);
    if (!labeling)
        return labeling.error();

    const SeamedMesh seamed =
        insertSeams(proxy, topology, labeling->labels, strokeCutPositions(proxy, topology, association));
    TriangleMesh inside = seamed.mesh;
    inside.triangles.clear();
    for (std::size_t i = 0; i < seamed.mesh.triangles.size(); ++i)
        if (seamed.triangleLabels[i] == 0)
            inside.triangles.push_back(seamed.mesh.triangles[i]);
    if (inside.triangles.size() < 20)
        return Error{ErrorCode::NoSolution, "Trimming the open surface",
                     "the boundary strokes enclose nothing on the proxy",
                     "Mark the strokes along the border of the surface, and no others, as boundary", ""};
    return compacted(inside);
}

std::vector<double> strokeCutPositions(const TriangleMesh &mesh, const MeshTopology &topology,
                                       const Association &association)
{
    std::vector<double> sum(topology.edges.size(), 0.0);
    std::vector<int> count(topology.edges.size(), 0);
    for (std::size_t i = 0; i < association.samples.size(); ++i) {
        const std::size_t e = std::size_t(association.samples[i].edge);
        const Vec3 &a = mesh.vertices[std::size_t(topology.edges[e].v0)];
        const Vec3 ab = mesh.vertices[std::size_t(topology.edges[e].v1)] - a;
        sum[e] += std::clamp((association.points[i].point - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
        ++count[e];
    }
    std::vector<double> positions(topology.edges.size(), 0.5);
    for (std::size_t e = 0; e < positions.size(); ++e)
        if (count[e])
            positions[e] = sum[e] / count[e];
    return positions;
}

} // namespace ductus
