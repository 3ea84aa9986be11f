// How much a sketch must be smoothed before a smooth surface fits it: lambda of the variational fit, chosen
// automatically.
//
// Clean curves need none: the energy of the fit hardly depends on lambda (a torus: 11 from 1e-7 to 1e-3). Strokes
// drawn by hand miss each other where they should cross; a field through both must swing between them, and its energy
// is dozens of times that of the surface meant (CASSIE's hat: 1338 at 1e-7, 84 at 1e-3). So the least lambda is taken
// whose energy is that of a calm surface; where no lambda gives that, the shape itself is intricate, and the largest
// is taken that leaves the strokes no further than people draw off the mark. That bound holds for calm fits as well.
//
// Nothing below 1e-4 is tried: a proxy closer to the strokes than they were drawn helps nobody, and a nearly
// interpolating fit can end with a corner of a sheet turned over, however calm the rest.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"

namespace ductus {

struct LambdaChoiceOptions
{
    std::vector<double> lambdas = {1e-4, 3e-4, 1e-3, 2e-3}; // ascending, unit frame, at 600 points
    double calmEnergy = 90.0; // at most that of a calm surface; measured on smooth and on hand-drawn sketches
    double shellNoise = 0.010; // root mean square that strokes may be left by the fit, share of the diagonal; the
    double solidNoise = 0.006; // wrap keeps the fit of a solid calm, so it needs less smoothing than a shell's
    int points = 300;         // subset the choice is made on
};

/// A nugget for a fit to \a fitPointCount of \a strokePoints. Fails as fitVariational does.
Result<double> chooseLambda(const std::vector<Vec3> &strokePoints, int fitPointCount, bool isShell,
                            const LambdaChoiceOptions &options, const JobControl &control);

} // namespace ductus
