#include "surfacing/proxy/sphere_descent.h"

#include <cmath>
#include <deque>

namespace ductus {

namespace {

Eigen::VectorXd projected(const Eigen::VectorXd &g, const Eigen::VectorXd &vector)
{
    const Eigen::Index n = g.size() / 3;
    Eigen::VectorXd result = vector;
    for (Eigen::Index i = 0; i < n; ++i) {
        const double along = g[i] * vector[i] + g[n + i] * vector[n + i] + g[2 * n + i] * vector[2 * n + i];
        for (int k = 0; k < 3; ++k)
            result[k * n + i] -= along * g[k * n + i];
    }
    return result;
}

Eigen::VectorXd retracted(const Eigen::VectorXd &g)
{
    const Eigen::Index n = g.size() / 3;
    Eigen::VectorXd result = g;
    for (Eigen::Index i = 0; i < n; ++i) {
        const double length = std::sqrt(g[i] * g[i] + g[n + i] * g[n + i] + g[2 * n + i] * g[2 * n + i]);
        for (int k = 0; k < 3; ++k)
            result[k * n + i] /= length;
    }
    return result;
}

struct CurvaturePair
{
    Eigen::VectorXd step, change;
};

Eigen::VectorXd descentDirection(const Eigen::VectorXd &gradient, const std::deque<CurvaturePair> &pairs)
{
    Eigen::VectorXd q = gradient;
    std::vector<double> alpha(pairs.size());
    for (std::size_t i = pairs.size(); i-- > 0;) {
        alpha[i] = pairs[i].step.dot(q) / pairs[i].step.dot(pairs[i].change);
        q -= alpha[i] * pairs[i].change;
    }
    if (!pairs.empty())
        q *= pairs.back().step.dot(pairs.back().change) / pairs.back().change.squaredNorm();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const double beta = pairs[i].change.dot(q) / pairs[i].step.dot(pairs[i].change);
        q += (alpha[i] - beta) * pairs[i].step;
    }
    return -q;
}

} // namespace

Result<SphereMinimum> minimiseOnSpheres(const std::function<Eigen::VectorXd(const Eigen::VectorXd &)> &applyH,
                                        const Eigen::VectorXd &start, const SphereDescentOptions &options,
                                        const JobControl &control)
{
    SphereMinimum best;
    best.g = start;
    Eigen::VectorXd Hg = applyH(best.g);
    best.energy = best.g.dot(Hg);
    best.evaluations = 1;
    Eigen::VectorXd gradient = projected(best.g, 2.0 * Hg);
    std::deque<CurvaturePair> pairs;

    for (int iteration = 0; iteration < options.maxIterations; ++iteration) {
        if (control.isCancelled())
            return cancelledError("Finding stroke normals");
        Eigen::VectorXd direction = projected(best.g, descentDirection(gradient, pairs));
        double slope = gradient.dot(direction);
        if (!(slope < 0.0)) {
            pairs.clear();
            direction = -gradient;
            slope = -gradient.squaredNorm();
        }
        if (slope > -1e-14 * best.energy)
            break;
        // The first step has no curvature yet: turn no vector by more than half a radian or so.
        double length = 1.0;
        if (pairs.empty())
            length = 0.5 / std::max(direction.cwiseAbs().maxCoeff(), 1e-300);
        bool accepted = false;
        for (int halving = 0; halving < 30 && !accepted; ++halving, length *= 0.5) {
            const Eigen::VectorXd g = retracted(best.g + length * direction);
            const Eigen::VectorXd trialHg = applyH(g);
            ++best.evaluations;
            const double energy = g.dot(trialHg);
            if (energy > best.energy + 1e-4 * length * slope)
                continue;
            accepted = true;
            const Eigen::VectorXd newGradient = projected(g, 2.0 * trialHg);
            CurvaturePair pair{projected(g, g - best.g), newGradient - projected(g, gradient)};
            if (pair.step.dot(pair.change) > 1e-12 * pair.step.norm() * pair.change.norm()) {
                pairs.push_back(std::move(pair));
                if (int(pairs.size()) > options.memory)
                    pairs.pop_front();
            }
            const double decrease = best.energy - energy;
            best.g = g;
            gradient = newGradient;
            best.energy = energy;
            if (decrease < options.tolerance * energy)
                return best;
        }
        if (!accepted)
            break;
    }
    return best;
}

} // namespace ductus
