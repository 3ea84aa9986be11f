// The lowest rung of the proxy ladder: a closed manifold around the strokes that cannot fail. The wrap is as tight
// as it can be before it enters the shape through the holes between strokes.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"

namespace ductus {

struct WrapOptions
{
    // Sizes of ball that must not fit through the holes, share of the box diagonal, loose to tight
    // (surfacing-research.md: /6 sphere-like, /10 follows spout and handle of a teapot, /20 opens holes).
    std::vector<double> alphas = {1.0 / 5, 1.0 / 7, 1.0 / 10, 1.0 / 14, 1.0 / 20};
    double offset = 1.0 / 120;     // distance kept from the strokes, share of the diagonal
    double keptVolume = 0.8;       // a wrap that loses more than this share of the looser one's volume fell in
    double tightness = -1.0;       // 0..1 picks along alphas; negative: chosen by keptVolume
};

struct Wrap
{
    TriangleMesh mesh; // closed, outwards; may have several components
    double alpha = 0.0;
};

/// \a points: samples of the strokes in the unit frame, closer together than the smallest alpha.
Result<Wrap> wrapStrokes(const std::vector<Vec3> &points, const WrapOptions &options, const JobControl &control);

} // namespace ductus
