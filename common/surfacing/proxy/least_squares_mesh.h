// Attraction of a proxy to the strokes: a Least-Squares Mesh [Sorkine, Cohen-Or 2004] of the proxy's connectivity
// with the projected stroke points as control points (thesis Sec. III.6, Fig. III.8).
//
//     min  sum_v |L x|^2_v + w_control sum_p |B_p x - p|^2 + w_anchor sum_v |x_v - x0_v|^2
//
// L is the graph Laplacian. The anchor is weak; it only decides where no stroke says anything.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"

namespace ductus {

struct AttractionOptions
{
    double controlWeight = 0.3;
    double anchorWeight = 1e-5;
    double borderAnchorWeight = 0.1; // borders of open proxies would shrink
    double maxDistance = 0.06;       // strokes further away do not pull, share of the box diagonal
    int rounds = 3;                  // project and solve; later ones use better feet
};

/// \a strokePoints: even samples. The connectivity stays, vertices move.
Result<TriangleMesh> attracted(const TriangleMesh &proxy, const std::vector<Vec3> &strokePoints,
                               const AttractionOptions &options, const JobControl &control);

} // namespace ductus
