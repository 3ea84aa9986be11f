#include "surfacing/proxy/local/patch_fit.h"

namespace ductus {

Result<PatchFit> fitPatch(const Patch &patch, const std::vector<Vec3> &points, double lambda,
                          const std::vector<Vec3> &prior, const JobControl &control)
{
    std::vector<Vec3> scaled;
    for (int i : patch.members)
        scaled.push_back((points[std::size_t(i)] - patch.centre) / patch.radius);
    VariationalFitOptions options;
    // Values scale with the length, their weight beside the energy with its cube. A trace of smoothing keeps
    // points drawn twice apart.
    options.lambda = lambda / (patch.radius * patch.radius * patch.radius) + 1e-9;
    options.slopeRidge = 1e-4;
    options.maxIterations = 60;
    options.tolerance = 1e-4;
    Result<VariationalFit> fit = fitVariational(scaled, prior, options, control.silenced());
    if (!fit)
        return fit.error();
    return PatchFit{std::move(fit->field), std::move(fit->normals), fit->energy,
                    fit->rmsValue * patch.radius};
}

} // namespace ductus
