// Trimming of open surfaces (thesis Sec. III.5.4, Fig. III.7): a graph cut on the proxy parts what the strokes
// enclose from what lies beyond, along boundary strokes where the user marked them.
//
// Without marked strokes (beyond the thesis) the outermost strokes are taken: everything a stroke lies on is inside,
// and the shortest cut around it is made.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "surfacing/association/association.h"

namespace ductus {

struct BoundaryTrimOptions
{
    double crossedByBoundary = 1e-3; // cost of cutting an edge a boundary stroke crosses (the thesis: 0)
    int clearanceRings = 4;          // vertices this far from boundary strokes that have stroke points are inside
};

/// \a proxy without its part beyond the boundary; unchanged if it has no border apart from \a inPlane vertices.
/// Fails with NoSolution if nothing would be left.
Result<TriangleMesh> trimmed(const TriangleMesh &proxy, const MeshTopology &topology, const Association &association,
                             const StrokeSet &strokes, const std::vector<char> &inPlane,
                             const BoundaryTrimOptions &options, const JobControl &control);

/// Where edges are crossed by strokes, from v0 (0) to v1 (1); 0.5 elsewhere. For insertSeams.
std::vector<double> strokeCutPositions(const TriangleMesh &mesh, const MeshTopology &topology,
                                       const Association &association);

} // namespace ductus
