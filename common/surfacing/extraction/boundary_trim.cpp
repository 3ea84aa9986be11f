#include "surfacing/extraction/boundary_trim.h"

#include "geometry/hole_filling.h"
#include "numeric/alpha_expansion.h"
#include "surfacing/extraction/seam_insertion.h"

#include <algorithm>

namespace ductus {

namespace {

struct Terminals
{
    std::vector<char> inside, outside;
    std::vector<char> edgeIsBoundary; // crossed by a boundary stroke
};

// Vertices of the proxy's border; without loops shorter than \a holeShare of the longest.
std::vector<char> rimOf(const TriangleMesh &proxy, double holeShare)
{
    std::vector<char> isRim(proxy.vertices.size(), 0);
    const std::vector<std::vector<int>> loops = borderLoops(proxy);
    for (const std::vector<int> &loop : loops)
        if (loopLength(proxy, loop) >= holeShare * loopLength(proxy, loops.front()))
            for (const int v : loop)
                isRim[std::size_t(v)] = 1;
    return isRim;
}

Terminals terminals(const MeshTopology &topology, const Association &association,
                    const std::vector<char> &isRim, const std::vector<char> &strokeIsBorder,
                    const std::vector<char> &inPlane, const BoundaryTrimOptions &options)
{
    Terminals t;
    const std::size_t vertexCount = association.pointsOfVertex.size();
    t.edgeIsBoundary.assign(topology.edges.size(), 0);
    std::vector<char> nearBoundary(vertexCount, 0);
    for (const StrokeSample &sample : association.samples)
        if (strokeIsBorder[std::size_t(sample.stroke)]) {
            t.edgeIsBoundary[std::size_t(sample.edge)] = 1;
            nearBoundary[std::size_t(topology.edges[std::size_t(sample.edge)].v0)] = 1;
            nearBoundary[std::size_t(topology.edges[std::size_t(sample.edge)].v1)] = 1;
        }
    const bool isMarked = std::find(nearBoundary.begin(), nearBoundary.end(), 1) != nearBoundary.end();
    if (isMarked)
        nearBoundary = grownByRings(nearBoundary, topology, options.clearanceRings);
    t.inside.assign(vertexCount, 0);
    for (std::size_t v = 0; v < vertexCount; ++v)
        t.inside[v] = !association.pointsOfVertex[v].empty() && !nearBoundary[v];
    t.outside = isRim;
    for (std::size_t v = 0; v < vertexCount; ++v)
        t.outside[v] = t.outside[v] && !t.inside[v] && (inPlane.empty() || !inPlane[v]);
    return t;
}

bool any(const std::vector<char> &flags)
{
    return std::find(flags.begin(), flags.end(), 1) != flags.end();
}

// The shortest cut: 0 inside, 1 outside, one a vertex.
Result<std::vector<int>> shortestCut(const TriangleMesh &proxy, const MeshTopology &topology,
                                     const Terminals &t, const BoundaryTrimOptions &options,
                                     const JobControl &control)
{
    LabelingProblem cut;
    cut.vertexCount = proxy.vertexCount();
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const MeshEdge &edge = topology.edges[e];
        const double length =
            (proxy.vertices[std::size_t(edge.v0)] - proxy.vertices[std::size_t(edge.v1)]).norm();
        cut.edges.push_back(
            {edge.v0, edge.v1, t.edgeIsBoundary[e] ? length * options.crossedByBoundary : length});
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
    const Result<Labeling> labeling =
        alphaExpansion(cut, {}, std::vector<int>(t.inside.size(), 0), control.silenced());
    if (!labeling)
        return labeling.error();
    return labeling->labels;
}

std::vector<char> strokesMarkedBoundary(const StrokeSet &strokes)
{
    std::vector<char> marked;
    for (const Stroke &stroke : strokes.strokes)
        marked.push_back(stroke.role == StrokeRole::Boundary);
    return marked;
}

} // namespace

Result<TrimmedProxy> trimmed(const TriangleMesh &proxy, const MeshTopology &topology,
                             const Association &association, const StrokeSet &strokes,
                             const std::vector<char> &inPlane, const BoundaryTrimOptions &options,
                             const JobControl &control)
{
    std::vector<char> strokeIsBorder = strokesMarkedBoundary(strokes);
    const std::vector<char> isRim = rimOf(proxy, any(strokeIsBorder) ? 0.0 : options.holeShare);
    Terminals t = terminals(topology, association, isRim, strokeIsBorder, inPlane, options);
    if (!any(t.outside))
        return TrimmedProxy{proxy, {}};
    Result<std::vector<int>> side = shortestCut(proxy, topology, t, options, control);
    if (!side)
        return side.error();
    if (!any(strokeIsBorder)) {
        std::vector<char> isBeyond = t.outside;
        for (std::size_t v = 0; v < isBeyond.size(); ++v)
            isBeyond[v] = isBeyond[v] || (*side)[v] == 1;
        strokeIsBorder =
            strokesAlongBorder(proxy, topology, association, strokes, isBeyond, options.borderStrokes);
        if (any(strokeIsBorder)) {
            t = terminals(topology, association, isRim, strokeIsBorder, inPlane, options);
            side = shortestCut(proxy, topology, t, options, control);
            if (!side)
                return side.error();
        }
    }

    const SeamedMesh seamed =
        insertSeams(proxy, topology, *side, strokeCutPositions(proxy, topology, association));
    TriangleMesh inside = seamed.mesh;
    inside.triangles.clear();
    for (std::size_t i = 0; i < seamed.mesh.triangles.size(); ++i)
        if (seamed.triangleLabels[i] == 0)
            inside.triangles.push_back(seamed.mesh.triangles[i]);
    if (inside.triangles.size() < 20)
        return Error{ErrorCode::NoSolution, "Trimming the open surface",
                     "the boundary strokes enclose nothing on the proxy",
                     "Mark the strokes along the border of the surface, and no others, as boundary", ""};
    TrimmedProxy result{compacted(inside), {}};
    for (std::size_t s = 0; s < strokeIsBorder.size(); ++s)
        if (strokeIsBorder[s])
            result.borderStrokes.strokes.push_back(strokes.strokes[s]);
    return result;
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
