// How much the points of a set must be smoothed, and how far off they lie from what they sample.
#pragma once

#include "surfacing/proxy/local/patch_fit.h"

namespace ductus {

struct Smoothing
{
    double lambda = 0.0; // for fitPatch
    double noise =
        0.0; // standard deviation of the points off their surface that this lambda tells, input units
};

/// By generalised cross-validation [Craven, Wahba 1979] on some of the patches: the misfit, divided by the
/// square of the share of the freedom the fit leaves, is least where noise is smoothed away and shape is not.
/// Amounts of smoothing that leave the patches crumpled are not considered.
Result<Smoothing> chooseSmoothing(const std::vector<Patch> &patches, const std::vector<Vec3> &points,
                                  const JobControl &control);

} // namespace ductus
