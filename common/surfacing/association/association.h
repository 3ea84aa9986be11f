// Stroke information on the proxy (thesis Sec. III.5.1): which mesh edges each stroke crosses, which stroke points
// each vertex answers for, and the weight of cutting each edge.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/mesh_topology.h"
#include "strokes/stroke.h"
#include "surfacing/segmentation/model_fit.h"

namespace ductus {

struct AssociationOptions
{
    double crossedEdgeWeight = 1.0;     // w^e, Sec. III.5.1
    double uncrossedEdgeWeight = 100.0; // w^e, Sec. III.5.1
    double maxDistance = 0.08;          // strokes further from the proxy are left out, share of the box diagonal
};

/// One sample of a stroke where it crosses a proxy edge.
struct StrokeSample
{
    int stroke = -1; // index into the StrokeSet
    int edge = -1;   // of the topology
};

struct Association
{
    std::vector<OrientedPoint> points;              // stroke points and the proxy's normals there
    std::vector<StrokeSample> samples;              // beside points
    std::vector<OrientedPoint> vertices;            // the proxy's, with their normals
    std::vector<int> vertexCounts;                  // how many vertices each stands for; empty: one
    std::vector<std::vector<int>> pointsOfVertex;   // P_v: indices into points, at most one an edge
    std::vector<double> edgeWeights;                // w^e c^e of Sec. III.6
    std::vector<char> edgeIsCrossed;                // by a stroke that carries surface or border
    int pairCount = 0;                              // N_p of Eq. III.2: sum of |P_v|
    std::vector<int> unreachedStrokes;              // strokes no part of which lies near the proxy

    double countAt(std::size_t v) const { return vertexCounts.empty() ? 1.0 : vertexCounts[v]; }
};

/// \a strokes in the unit frame, single points of a cloud among them; those with roles other than Surface and Boundary are passed over.
Result<Association> associate(const StrokeSet &strokes, const TriangleMesh &proxy, const MeshTopology &topology,
                              const AssociationOptions &options, const JobControl &control);

} // namespace ductus
