#include "surfacing/proxy/local/smoothing_choice.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

struct Trial
{
    double share;   // lambda, as a share of the cube of the patches' radius
    double freedom; // misfit of pure noise after the fit, as a share of the noise
};

// Freedom measured on patches of 48 noisy points of a sphere, a torus and a cube, where it hardly differs.
constexpr Trial trials[] = {{1e-3, 0.12}, {1e-2, 0.46}, {1e-1, 0.77}, {1.0, 0.91}, {10.0, 0.96}};

// A patch is calm up to here: one of a thin plate, both sides in it, has an energy of 1.8, one at a cube's
// corner 2.2, one whose normals lie wildly among noise 10 to 20.
constexpr double calmEnergy = 5.5;

constexpr double worthwhile = 0.95; // of the score: more smoothing for less than that is not

std::vector<const Patch *> someOf(const std::vector<Patch> &patches, std::size_t count)
{
    std::vector<const Patch *> some;
    const std::size_t n = std::min(count, patches.size());
    for (std::size_t i = 0; i < n; ++i)
        some.push_back(&patches[i * patches.size() / n]);
    return some;
}

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
}

double rootMeanSquare(const std::vector<double> &values)
{
    double sum = 0.0;
    for (double value : values)
        sum += value * value / double(values.size());
    return std::sqrt(sum);
}

} // namespace

Result<Smoothing> chooseSmoothing(const std::vector<Patch> &patches, const std::vector<Vec3> &points,
                                  const JobControl &control)
{
    const std::vector<const Patch *> some = someOf(patches, 60);
    if (some.empty())
        return Smoothing{};
    std::vector<double> radii;
    for (const Patch *patch : some)
        radii.push_back(patch->radius);
    const double radius = median(radii), cube = radius * radius * radius;

    Smoothing best;
    double bestScore = 0.0;
    for (const Trial &trial : trials) {
        if (control.isCancelled())
            return cancelledError("Measuring how exact the points are");
        std::vector<double> misfits(some.size(), -1.0), energies(some.size(), -1.0);
        parallelFor(0, some.size(), [&](std::size_t i) {
            const Result<PatchFit> fit = fitPatch(*some[i], points, trial.share * cube, {}, control);
            if (fit) {
                misfits[i] = fit->rmsValue;
                energies[i] = fit->energy;
            }
        });
        std::erase(misfits, -1.0);
        std::erase(energies, -1.0);
        if (misfits.empty())
            continue;
        // Of all patches and not of a common one: a crease that is rounded must count.
        const double misfit = rootMeanSquare(misfits), score = misfit / (trial.freedom * trial.freedom);
        const bool isLast = trial.share == std::end(trials)[-1].share;
        if ((median(energies) <= calmEnergy || (isLast && best.lambda == 0.0)) &&
            (best.lambda == 0.0 || score < worthwhile * bestScore)) {
            best = {trial.share * cube, misfit / trial.freedom};
            bestScore = score;
        }
    }
    return best;
}

} // namespace ductus
