#include "doodling/tracking/trajectory.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

Error unusable(const std::string &problem)
{
    return {ErrorCode::InvalidArgument, "Following the canvas", problem,
            "Remove the keyframe and set it again in the player", ""};
}

Result<void> checkInput(const std::vector<FlowStep> &steps, const std::vector<PositionKeyframe> &keyframes)
{
    if (keyframes.empty())
        return unusable("there is no position keyframe");
    for (const FlowStep &step : steps)
        if (!step.motion.allFinite() || !std::isfinite(step.confidence) || step.confidence <= 0.0)
            return unusable("the motion of the scene is not a number");
    int last = -1;
    for (const PositionKeyframe &key : keyframes) {
        if (key.frame <= last || key.frame > int(steps.size()))
            return unusable("keyframe at frame " + std::to_string(key.frame) +
                            " is out of order or beyond the clip");
        if (!key.eye.allFinite() || !key.ray.allFinite() || key.ray.isZero() || !(key.depth > 0.0) ||
            !std::isfinite(key.depth))
            return unusable("keyframe at frame " + std::to_string(key.frame) + " has no place");
        last = key.frame;
    }
    return {};
}

// What lies between two keyframes.
struct Span
{
    Vec3 motion = Vec3::Zero(); // sum of the flow
    double slack = 0.0;         // sum of 1 / w: how easily it takes a correction
    bool isTracked = true;
};

std::vector<Span> spansBetween(const std::vector<FlowStep> &steps,
                               const std::vector<PositionKeyframe> &keyframes)
{
    std::vector<Span> spans(keyframes.size() - 1);
    for (std::size_t k = 0; k < spans.size(); ++k) {
        spans[k].isTracked = !keyframes[k].interpolatesNext;
        for (int t = keyframes[k].frame; t < keyframes[k + 1].frame; ++t) {
            spans[k].motion += steps[std::size_t(t)].motion;
            spans[k].slack += 1.0 / steps[std::size_t(t)].confidence;
        }
    }
    return spans;
}

// The keyframes' depths: a symmetric tridiagonal system, solved by elimination. Positive definite, since
// every free depth has lambda |d|^2 on the diagonal.
std::vector<double> solveDepths(const std::vector<Span> &spans,
                                const std::vector<PositionKeyframe> &keyframes,
                                const TrajectoryOptions &options)
{
    const std::size_t n = keyframes.size();
    std::vector<double> diagonal(n, 0.0), next(n, 0.0), right(n, 0.0);
    for (std::size_t k = 0; k < n; ++k) {
        const double weight = options.depthWeight * keyframes[k].ray.squaredNorm();
        diagonal[k] = weight;
        right[k] = weight * keyframes[k].depth;
    }
    for (std::size_t k = 0; k + 1 < n; ++k) {
        if (!spans[k].isTracked)
            continue;
        const PositionKeyframe &a = keyframes[k], &b = keyframes[k + 1];
        const double stiffness = 1.0 / spans[k].slack;
        const Vec3 gap = b.eye - a.eye - spans[k].motion; // at depths zero
        diagonal[k] += stiffness * a.ray.squaredNorm();
        diagonal[k + 1] += stiffness * b.ray.squaredNorm();
        next[k] = -stiffness * a.ray.dot(b.ray);
        right[k] += stiffness * a.ray.dot(gap);
        right[k + 1] -= stiffness * b.ray.dot(gap);
    }
    for (std::size_t k = 0; k < n; ++k) { // known depths leave the system
        if (!keyframes[k].isDepthFixed)
            continue;
        if (k > 0) {
            right[k - 1] -= next[k - 1] * keyframes[k].depth;
            next[k - 1] = 0.0;
        }
        if (k + 1 < n) {
            right[k + 1] -= next[k] * keyframes[k].depth;
            next[k] = 0.0;
        }
        diagonal[k] = 1.0;
        right[k] = keyframes[k].depth;
    }
    for (std::size_t k = 0; k + 1 < n; ++k) {
        const double factor = next[k] / diagonal[k];
        diagonal[k + 1] -= factor * next[k];
        right[k + 1] -= factor * right[k];
    }
    std::vector<double> depths(n);
    for (std::size_t k = n; k-- > 0;) {
        const double later = k + 1 < n ? next[k] * depths[k + 1] : 0.0;
        depths[k] = (right[k] - later) / diagonal[k];
    }
    for (std::size_t k = 0; k < n; ++k)
        if (!keyframes[k].isDepthFixed)
            depths[k] = std::max(depths[k], options.nearestDepth);
    return depths;
}

void fillSpan(const std::vector<FlowStep> &steps, const Span &span, int from, int to,
              std::vector<Vec3> &positions)
{
    const Vec3 whole = positions[std::size_t(to)] - positions[std::size_t(from)];
    Vec3 place = positions[std::size_t(from)];
    for (int t = from; t + 1 < to; ++t) {
        const FlowStep &step = steps[std::size_t(t)];
        if (span.isTracked)
            place += step.motion + (whole - span.motion) / (step.confidence * span.slack);
        else
            place += whole / double(to - from);
        positions[std::size_t(t) + 1] = place;
    }
}

} // namespace

Result<std::vector<Vec3>> solveTrajectory(const std::vector<FlowStep> &steps,
                                          const std::vector<PositionKeyframe> &keyframes,
                                          const TrajectoryOptions &options)
{
    if (Result<void> checked = checkInput(steps, keyframes); !checked)
        return checked.error();
    const std::vector<Span> spans = spansBetween(steps, keyframes);
    const std::vector<double> depths = solveDepths(spans, keyframes, options);
    std::vector<Vec3> positions(steps.size() + 1);
    for (std::size_t k = 0; k < keyframes.size(); ++k)
        positions[std::size_t(keyframes[k].frame)] = keyframes[k].eye + depths[k] * keyframes[k].ray;
    for (std::size_t k = 0; k < spans.size(); ++k)
        fillSpan(steps, spans[k], keyframes[k].frame, keyframes[k + 1].frame, positions);
    for (int t = keyframes.front().frame; t-- > 0;)
        positions[std::size_t(t)] = positions[std::size_t(t) + 1] - steps[std::size_t(t)].motion;
    for (std::size_t t = std::size_t(keyframes.back().frame); t < steps.size(); ++t)
        positions[t + 1] = positions[t] + steps[t].motion;
    return positions;
}

} // namespace ductus
