#include "doodling/reconstruction/depth/still_depth.h"

#include "doodling/reconstruction/depth/static_depth.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double goodSpread = 0.04;          // of the usual inverse depth: exacter ones count no more
constexpr double mostStillMiss = 1.3;        // pixels at 854 of width
constexpr double oddDeviation = 0.2;         // of a cell's disparity, from what is around
constexpr double leastDisparityShare = 0.02; // of the usual one
constexpr double floating = 1.7;             // times nearer than all below it, and than what is usual
constexpr float wideWeight = 0.03f;          // of what lies around, where a cell itself is known
constexpr float pastWeight = 0.35f;          // of the frame before

// Things stand on the ground, which comes nearer downwards: what seems far nearer than all below it moves
// along the camera's way and only looks near.
void distrustFloating(const std::vector<float> &inverseDepths, const std::vector<float> &wide, int width,
                      int height, double usual, std::vector<float> &weights)
{
    for (int x = 0; x < width; ++x) {
        float nearestBelow = 0.0f;
        for (int y = height - 1; y >= 0; --y) {
            const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
            const double most = floating * std::max(double(nearestBelow), usual);
            if (double(inverseDepths[i]) > most && y < height - 2)
                weights[i] *= 0.02f;
            else
                nearestBelow = std::max(nearestBelow, wide[i]);
        }
    }
}

std::vector<float> weightsOf(const Shot &shot, const StaticDepth &measured,
                             std::span<const std::uint8_t> objects, double usual)
{
    const double mostMiss = mostStillMiss * std::max(0.6, shot.width / 854.0);
    std::vector<float> weights;
    weights.reserve(objects.size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const double inverse = double(measured.inverseDepths[i]);
        const double spread = double(measured.spreads[i]);
        const double share = spread / std::max(usual, inverse);
        const bool isMeasured =
            std::isfinite(spread) && inverse < shot.nearestDisparity && inverse > -2.0 * spread;
        const bool isStill =
            objects[i] == 0 && measured.misses[i] >= 0.0f && double(measured.misses[i]) < mostMiss;
        weights.push_back(
            isMeasured && isStill ? float(1.0 / (1.0 + share * share / (goodSpread * goodSpread))) : 0.0f);
    }
    return weights;
}

// What the frame before says, moved along with the flow and seen from here; 0 where it says nothing.
std::vector<float> carried(const Shot &shot, int frame, std::span<const std::uint8_t> objects,
                           std::span<const float> before)
{
    const CompactFlow &back = shot.backward[std::size_t(frame) - 1];
    const ShotCamera &here = shot.cameras[std::size_t(frame)];
    const ShotCamera &there = shot.cameras[std::size_t(frame) - 1];
    std::vector<float> disparities(before.size(), 0.0f);
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (back.cellConfidence(i) < 0.5f || objects[i] != 0)
            continue;
        const Vec2 origin = back.cellMiddle(i) + back.cellMotion(i).cast<double>();
        const double disparity = double(before[back.cellAt(origin)]);
        const double depth = here.depthOf(there.unprojected(origin, 1.0 / disparity));
        if (depth > 0.0)
            disparities[i] = float(1.0 / depth);
    }
    return disparities;
}

} // namespace

StillFrame stillFrame(const Shot &shot, int frame, EdgeWeights edges, std::span<const std::uint8_t> objects)
{
    const double usual = 1.0 / shot.sceneDepth;
    StaticDepth measured = staticDepth(shot, frame, usual);
    StillFrame still;
    still.edges = std::move(edges);
    still.weights = weightsOf(shot, measured, objects, usual);
    still.inverseDepths = std::move(measured.inverseDepths);
    still.wide = smoothed(still.edges, still.inverseDepths, still.weights, {600.0, 3});
    // What is unlike its surroundings was measured wrongly: flow slips at silhouettes.
    for (std::size_t i = 0; i < still.weights.size(); ++i) {
        const double odd = double(still.inverseDepths[i] - still.wide[i]) /
                           (oddDeviation * std::max(double(still.wide[i]), 0.3 * usual));
        still.weights[i] *= float(1.0 / (1.0 + odd * odd));
    }
    distrustFloating(still.inverseDepths, still.wide, still.edges.width, still.edges.height, usual,
                     still.weights);
    still.wide = smoothed(still.edges, still.inverseDepths, still.weights, {600.0, 3});
    return still;
}

std::vector<float> stillDisparities(const Shot &shot, int frame, const StillFrame &still,
                                    std::span<const std::uint8_t> objects, std::span<const float> before)
{
    std::vector<float> past;
    if (!before.empty())
        past = carried(shot, frame, objects, before);
    std::vector<float> values(still.weights.size()), weights(still.weights.size());
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const float pastShare = past.empty() || past[i] <= 0.0f ? 0.0f : pastWeight;
        weights[i] = still.weights[i] + wideWeight + pastShare;
        values[i] = (still.weights[i] * still.inverseDepths[i] + wideWeight * still.wide[i] +
                     (pastShare > 0.0f ? pastShare * past[i] : 0.0f)) /
                    weights[i];
    }
    std::vector<float> disparities = smoothed(still.edges, values, weights, {4.0, 2});
    for (float &disparity : disparities)
        disparity = std::max(disparity, float(leastDisparityShare / shot.sceneDepth));
    return disparities;
}

} // namespace ductus
