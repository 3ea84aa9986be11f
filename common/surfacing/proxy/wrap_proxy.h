// Wraps of the strokes at several tightnesses, and what they tell: how tight a closed proxy can be before it
// falls in through the holes between strokes, and whether the sketch is a solid or a shell.
//
// A wrap around a solid keeps its volume while it tightens and then loses much of it at once, its area grows
// and handles appear, when the ball of radius alpha fits between strokes. Around a shell it becomes a thin
// double layer whose area stays what it was and whose topology stays that of a sphere.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"

namespace ductus {

struct WrapOptions
{
    // Balls that must not fit through the holes, share of the box diagonal, loose to tight.
    std::vector<double> alphas = {1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,  1.0 / 7, 1.0 / 8.5,
                                  1.0 / 10, 1.0 / 12, 1.0 / 14, 1.0 / 17, 1.0 / 20};
    double offset = 1.0 / 120;    // distance kept from the strokes, share of the diagonal
    double keptVolume = 0.8;      // a step that loses more than the rest of the volume fell in
    double leastUncovered = 5e-4; // unless strokes come out: mean over all of them, share of the diagonal
    double areaGrowth = 1.15; // and so did one that has grown by more than this over the least area so far
    double thickness = 0.05;  // layers nearer than this are thin, share of the diagonal
    double shellThinShare = 0.75; // of the area must be thin for a shell
    double shellAreaGrowth = 1.06;
    double tightness = -1.0; // 0..1 picks along alphas; negative: chosen as above
};

struct Wrap
{
    TriangleMesh mesh; // closed, outwards; may have several components
    double alpha = 0.0;
    bool isShell = false; // the thin layer around an open surface
    double offset = 0.0;  // kept from the strokes
};

/// \a points: samples of the strokes in the unit frame, closer together than the smallest alpha.
Result<Wrap> wrapStrokes(const std::vector<Vec3> &points, const WrapOptions &options,
                         const JobControl &control);

} // namespace ductus
