#include "doodling/reconstruction/depth/shot_depth.h"

#include "doodling/reconstruction/depth/edge_aware_smoothing.h"
#include "doodling/reconstruction/depth/ground_guess.h"
#include "doodling/reconstruction/depth/moving_cells.h"
#include "doodling/reconstruction/depth/object_depth.h"
#include "doodling/reconstruction/depth/static_depth.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr char attempted[] = "Finding how far away things are";
constexpr double colourSigma = 12.0;         // grey levels
constexpr double goodSpread = 0.04;          // of the usual inverse depth: exacter ones count no more
constexpr double mostStillMiss = 1.3;        // pixels at 854 of width
constexpr double oddDeviation = 0.2;         // of a cell's disparity, from what is around
constexpr double leastDisparityShare = 0.02; // of the usual one
constexpr double beyondPoints = 1.6;         // how much nearer than the nearest points anything may be
constexpr double floating = 1.7;             // times nearer than all below it, and than what is usual
constexpr float wideWeight = 0.03f;          // of what lies around, where a cell itself is known
constexpr float pastWeight = 0.35f;          // of the frame before

struct DepthRange
{
    double usual = 0.0; // inverse depths
    double most = 0.0;  // nearer than all but a few
};

DepthRange rangeOf(std::vector<double> inverses)
{
    if (inverses.empty())
        return {};
    std::sort(inverses.begin(), inverses.end());
    return {inverses[inverses.size() / 2], inverses[std::size_t(0.98 * double(inverses.size() - 1))]};
}

// Of the points as the cameras see them.
DepthRange depthRange(const Shot &shot, const std::vector<std::optional<HomogeneousPoint>> &points)
{
    std::vector<double> inverses;
    for (int t = 0; t < shot.frameCount(); t += std::max(1, shot.frameCount() / 8))
        for (const auto &point : points) {
            if (!point || point->w() <= 1e-9 * point->norm())
                continue;
            const ShotCamera &camera = shot.cameras[std::size_t(t)];
            const Vec3 place = point->head<3>() / point->w();
            const std::optional<Vec2> seen = camera.projected(place);
            if (seen && seen->x() > 0 && seen->y() > 0 && seen->x() < shot.width && seen->y() < shot.height)
                inverses.push_back(1.0 / camera.depthOf(place));
        }
    return rangeOf(std::move(inverses));
}

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

class DepthFinder
{
public:
    DepthFinder(Clip &clip, int mostLines, double nearest, Shot &shot, const JobControl &control)
        : mClip(clip), mMostLines(mostLines), mNearest(nearest), mShot(shot), mControl(control),
          mGrid(shot.forward.front())
    {
    }

    Result<void> find()
    {
        if (Result<void> found = findObjects(); !found)
            return found;
        std::vector<ObjectDisparities> contacts;
        std::vector<float> before;
        for (int t = 0; t < mShot.frameCount(); ++t) {
            if (mControl.isCancelled())
                return cancelledError(attempted);
            mControl.progress(0.4 + 0.6 * double(t) / mShot.frameCount(), attempted);
            Result<std::vector<float>> background = stillDisparities(t, before);
            if (!background)
                return background.error();
            before = std::move(*background);
            contacts.push_back(
                contactDisparities(mObjects[std::size_t(t)], before, mGrid.width, mGrid.height));
            mShot.depths.push_back(depthMapOf(mGrid.width, mGrid.height, mGrid.cellSize, before));
        }
        smoothOverTime(contacts);
        for (std::size_t t = 0; t < contacts.size(); ++t)
            putObjects(mShot.depths[t], mObjects[t], contacts[t]);
        return {};
    }

private:
    Result<EdgeWeights> edgesOf(int frame)
    {
        const Result<Image> image = mClip.frame(frame, mMostLines);
        if (!image)
            return image.error();
        return edgeWeights(*image, int(mGrid.cellSize), colourSigma);
    }

    Result<void> findObjects()
    {
        for (int t = 0; t < mShot.frameCount(); ++t) {
            if (mControl.isCancelled())
                return cancelledError(attempted);
            mControl.progress(0.4 * double(t) / mShot.frameCount(), "Finding what moves by itself");
            const Result<EdgeWeights> edges = edgesOf(t);
            if (!edges)
                return edges.error();
            std::vector<std::uint8_t> bytes;
            for (float likelihood : movingLikelihood(ownMotion(mShot, t), *edges, mShot.width))
                bytes.push_back(std::uint8_t(std::clamp(255.0f * likelihood, 0.0f, 255.0f)));
            mObjects.push_back(std::move(bytes));
        }
        voteAlongFlow(mShot, mObjects);
        mObjects = numberedObjects(mShot, mObjects);
        return {};
    }

    Result<std::vector<float>> stillDisparities(int frame, const std::vector<float> &before)
    {
        if (mShot.knowledge != CameraKnowledge::SolvedCameras)
            return guessedDisparities(mShot, frame, mGrid);
        const Result<EdgeWeights> edges = edgesOf(frame);
        if (!edges)
            return edges.error();
        const double usual = 1.0 / mShot.sceneDepth;
        const StaticDepth measured = staticDepth(mShot, frame, usual);
        std::vector<float> weights = weightsOf(measured, mObjects[std::size_t(frame)], usual);
        std::vector<float> wide = smoothed(*edges, measured.inverseDepths, weights, {600.0, 3});
        // What is unlike its surroundings was measured wrongly: flow slips at silhouettes.
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const double odd = double(measured.inverseDepths[i] - wide[i]) /
                               (oddDeviation * std::max(double(wide[i]), 0.3 * usual));
            weights[i] *= float(1.0 / (1.0 + odd * odd));
        }
        distrustFloating(measured.inverseDepths, wide, mGrid.width, mGrid.height, usual, weights);
        wide = smoothed(*edges, measured.inverseDepths, weights, {600.0, 3});
        const std::vector<float> past = carried(frame, before);
        std::vector<float> values(weights.size());
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const float pastShare = past.empty() || past[i] <= 0.0f ? 0.0f : pastWeight;
            const float sum = weights[i] + wideWeight + pastShare;
            values[i] = (weights[i] * measured.inverseDepths[i] + wideWeight * wide[i] +
                         (pastShare > 0.0f ? pastShare * past[i] : 0.0f)) /
                        sum;
            weights[i] = sum;
        }
        std::vector<float> still = smoothed(*edges, values, weights, {4.0, 2});
        for (float &disparity : still)
            disparity = std::max(disparity, float(leastDisparityShare * usual));
        return still;
    }

    std::vector<float> weightsOf(const StaticDepth &measured, const std::vector<std::uint8_t> &objects,
                                 double usual) const
    {
        const double mostMiss = mostStillMiss * std::max(0.6, mShot.width / 854.0);
        std::vector<float> weights;
        for (std::size_t i = 0; i < objects.size(); ++i) {
            const double inverse = double(measured.inverseDepths[i]);
            const double spread = double(measured.spreads[i]);
            const double share = spread / std::max(usual, inverse);
            const bool isMeasured = std::isfinite(spread) && inverse < mNearest && inverse > -2.0 * spread;
            const bool isStill =
                objects[i] == 0 && measured.misses[i] >= 0.0f && double(measured.misses[i]) < mostMiss;
            weights.push_back(isMeasured && isStill
                                  ? float(1.0 / (1.0 + share * share / (goodSpread * goodSpread)))
                                  : 0.0f);
        }
        return weights;
    }

    // What the frame before says, moved along with the flow and seen from here; 0 where it says nothing.
    std::vector<float> carried(int frame, const std::vector<float> &before) const
    {
        if (before.empty())
            return {};
        const FlowField &back = mShot.backward[std::size_t(frame) - 1];
        const ShotCamera &here = mShot.cameras[std::size_t(frame)];
        const ShotCamera &there = mShot.cameras[std::size_t(frame) - 1];
        std::vector<float> disparities(before.size(), 0.0f);
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (back.confidences[i] < 0.5f || mObjects[std::size_t(frame)][i] != 0)
                continue;
            const Vec2 pixel((double(i % std::size_t(mGrid.width)) + 0.5) * mGrid.cellSize,
                             (double(i / std::size_t(mGrid.width)) + 0.5) * mGrid.cellSize);
            const Vec2 origin = pixel + back.motions[i].cast<double>();
            const int x = std::clamp(int(origin.x() / mGrid.cellSize), 0, mGrid.width - 1);
            const int y = std::clamp(int(origin.y() / mGrid.cellSize), 0, mGrid.height - 1);
            const std::size_t cell = std::size_t(y) * std::size_t(mGrid.width) + std::size_t(x);
            const double depth = here.depthOf(there.unprojected(origin, 1.0 / double(before[cell])));
            if (depth > 0.0)
                disparities[i] = float(1.0 / depth);
        }
        return disparities;
    }

    void putObjects(DepthMap &map, const std::vector<std::uint8_t> &objects,
                    const ObjectDisparities &disparities) const
    {
        std::vector<float> all;
        for (std::size_t i = 0; i < objects.size(); ++i)
            all.push_back(objects[i] != 0 && disparities[objects[i]] > 0.0f ? disparities[objects[i]]
                                                                            : float(map.cellDisparity(i)));
        map = depthMapOf(map.width, map.height, map.cellSize, all);
        map.objects = objects;
    }

    Clip &mClip;
    int mMostLines;
    double mNearest; // inverse depth: what seems nearer was measured wrongly
    Shot &mShot;
    const JobControl &mControl;
    const FlowField &mGrid;
    std::vector<std::vector<std::uint8_t>> mObjects; // first likelihoods, then numbers; one a frame
};

} // namespace

Result<void> findDepth(Clip &clip, const std::vector<std::optional<HomogeneousPoint>> &points, int mostLines,
                       Shot &shot, const JobControl &control)
{
    shot.depths.clear();
    double nearest = 10.0 / shot.sceneDepth; // inverse depth
    if (shot.forward.empty())
        return {}; // a single picture: all of it at the scene's depth
    if (shot.knowledge == CameraKnowledge::SolvedCameras) {
        const DepthRange range = depthRange(shot, points);
        if (range.usual > 0.0) {
            for (ShotCamera &camera : shot.cameras)
                camera.worldFromCamera.translation() *= range.usual * shot.sceneDepth;
            nearest = beyondPoints * range.most / (range.usual * shot.sceneDepth);
        }
    }
    return DepthFinder(clip, mostLines, nearest, shot, control).find();
}

} // namespace ductus
