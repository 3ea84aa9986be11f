// Draws a seamed mesh onto its surface models (thesis Sec. III.5.4, Eq. III.9 to III.12):
//
//     E_mesh = sum_v sum_{a in labels(v)} dist(Z(f_a), v)^2 / |labels(v)|
//            + gamma_2D sum_v w_v |Delta_2D v|^2 + gamma_1D sum_{v on seams} |Delta_1D v|^2
//            + sum_{v on the border} |v - p_v|^2
//
// The distances are first order (f / |grad f|), so this is nonlinear least squares: Gauss-Newton, where each
// round treats a vertex as drawn to the tangent planes of its models. The thesis used L-BFGS and lost most of
// its time here. Each linear system couples x, y, z through the normals; it is solved by conjugate gradients
// with the scalar system gamma L^T W L + I, factored once, as preconditioner: a third of the unknowns and no
// re-factorisation.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "surfacing/extraction/seam_insertion.h"
#include "surfacing/segmentation/implicit_polynomial.h"
#include "surfacing/sketch/symmetry_plane.h"

#include <optional>

namespace ductus {

struct MeshOptimizationOptions
{
    double surfaceSmoothness = 100.0; // gamma_2D, Sec. III.5.4
    double seamSmoothness = 500.0;    // gamma_1D, Sec. III.5.4
    // The thesis (Sec. III.5.4): pi/8 and pi/3. There edges of less than 60 degrees are blunted, also where
    // someone drew them: of the drawn creases above 30 degrees of a bottle and a bent leaf 0.43 and 0.40 came
    // out, now 0.64 and 0.91, and no deviation grew.
    double smoothAngle = 0.2617993877991494; // pi/12: below, seams are smoothed over
    double sharpAngle = 0.5235987755982988;  // pi/6: above, seams are creases
    int maxRounds = 10;                      // of Gauss-Newton
    double stillness = 2e-4; // ends when no vertex moves further, share of the diagonal: a tenth of a pixel
    double trustDistance = 0.03; // a model further away than this pulls with falling weight: its level set
                                 // may be a stray sheet (share of the diagonal)
    double sliding = 0.1;  // pull back to the start, along the surface only: nothing else keeps a cap from
                           // slipping off the round end of a model and shrinking
    double damping = 2e-3; // Levenberg-Marquardt, on all directions
};

/// A vertex to be kept near a point (boundary strokes, Eq. III.12) or in a plane (symmetry).
struct BorderAttraction
{
    int vertex = -1;
    Vec3 target = Vec3::Zero();
};

struct OptimizedMesh
{
    TriangleMesh mesh;
    std::vector<double> seamSharpness; // 1 - w_v of every vertex: 1 on creases, 0 on smooth parts
    int rounds = 0;
};

/// With \a plane, border vertices that lie in it (flags \a inPlane, may be empty) stay in it, and the surface
/// is smoothed as if its mirror image continued beyond.
Result<OptimizedMesh> optimizeMesh(const SeamedMesh &seamed, const std::vector<ImplicitPolynomial> &models,
                                   const std::vector<BorderAttraction> &borderTargets,
                                   const std::optional<SymmetryPlane> &plane,
                                   const std::vector<char> &inPlane, const MeshOptimizationOptions &options,
                                   const JobControl &control);

} // namespace ductus
