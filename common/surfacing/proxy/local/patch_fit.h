// The variational fit of one patch, in the patch's own size so that all patches are alike for the numbers.
#pragma once

#include "surfacing/proxy/local/patches.h"
#include "surfacing/proxy/variational_fit.h"

namespace ductus {

struct PatchFit
{
    HermiteField field;        // in the patch's frame: centre at the origin, radius 1
    std::vector<Vec3> normals; // one a member
    double energy = 0.0;       // in the patch's frame
    double rmsValue = 0.0;     // distance the members are left, input units
};

/// \a lambda in the points' frame, as in fitVariational. \a prior: normals to start from as well, one a
/// member, or empty.
Result<PatchFit> fitPatch(const Patch &patch, const std::vector<Vec3> &points, double lambda,
                          const std::vector<Vec3> &prior, const JobControl &control);

} // namespace ductus
