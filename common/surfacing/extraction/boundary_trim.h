// Trimming of open surfaces (thesis Sec. III.5.4, Fig. III.7): a graph cut on the proxy parts what the
// strokes enclose from what lies beyond, along boundary strokes where the user marked them.
//
// Without marked strokes (beyond the thesis) the border is found in two cuts. The first keeps everything a
// stroke lies on and is the shortest one around it: it bridges gaps, but lies a triangle or two beyond the
// strokes and bulges around each end that was drawn too far. The strokes it runs along (border_strokes.h) are
// then taken for marked, and the second cut follows them.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "surfacing/association/association.h"
#include "surfacing/extraction/border_strokes.h"

namespace ductus {

struct BoundaryTrimOptions
{
    double crossedByBoundary = 1e-3; // cost of cutting an edge a boundary stroke crosses (the thesis: 0)
    int clearanceRings = 4; // vertices this far from boundary strokes that have stroke points are inside
    BorderStrokeOptions borderStrokes; // used where none is marked
    double holeShare = 0.5; // there, shorter loops than this share of the proxy's longest are holes between
                            // strokes: nothing is cut off towards them
};

struct TrimmedProxy
{
    TriangleMesh mesh;
    StrokeSet borderStrokes; // those marked, or found to run along the border
};

/// \a proxy without its part beyond the boundary; unchanged if it has no border apart from \a inPlane
/// vertices. Fails with NoSolution if nothing would be left.
Result<TrimmedProxy> trimmed(const TriangleMesh &proxy, const MeshTopology &topology,
                             const Association &association, const StrokeSet &strokes,
                             const std::vector<char> &inPlane, const BoundaryTrimOptions &options,
                             const JobControl &control);

/// Where edges are crossed by strokes, from v0 (0) to v1 (1); 0.5 elsewhere. For insertSeams.
std::vector<double> strokeCutPositions(const TriangleMesh &mesh, const MeshTopology &topology,
                                       const Association &association);

} // namespace ductus
