#include "surfacing/proxy/lambda_choice.h"

#include "base/parallel.h"
#include "surfacing/proxy/point_subset.h"
#include "surfacing/proxy/variational_fit.h"

#include <optional>

namespace ductus {

Result<double> chooseLambda(const std::vector<Vec3> &strokePoints, int fitPointCount, bool isShell,
                            const LambdaChoiceOptions &options, const JobControl &control)
{
    std::vector<Vec3> points;
    for (int i : farthestPoints(strokePoints, options.points, 1e-3))
        points.push_back(strokePoints[std::size_t(i)]);
    // The data term is a sum over points: half as many points need half the lambda for the same smoothing.
    const double perPoint = double(points.size()) / 600.0;
    std::vector<std::optional<Result<VariationalFit>>> fits(options.lambdas.size());
    parallelFor(0, fits.size(), [&](std::size_t i) {
        VariationalFitOptions fit;
        fit.lambda = options.lambdas[i] * perPoint;
        fit.maxIterations = 60;
        fits[i] = fitVariational(points, {}, fit, control.silenced());
    });
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < fits.size(); ++i) {
        if (!fits[i]->ok())
            return fits[i]->error();
        // More smoothing than people's imprecision asks for swallows thin parts, however calm the field gets.
        if (i > 0 && (*fits[i])->rmsValue > (isShell ? options.shellNoise : options.solidNoise))
            break;
        chosen = i;
        if ((*fits[i])->energy <= options.calmEnergy)
            break;
    }
    return options.lambdas[chosen] * double(fitPointCount) / 600.0;
}

} // namespace ductus
