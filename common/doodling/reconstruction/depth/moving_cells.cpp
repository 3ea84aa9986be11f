#include "doodling/reconstruction/depth/moving_cells.h"

#include "doodling/reconstruction/depth/flow_chains.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ductus {

namespace {

constexpr std::array gaps = {1, 2, 4, 8};
constexpr double surelyStill = 0.6; // pixels at 854 of width
constexpr double surelyMoving = 2.2;
constexpr double usualMiss = 0.3;    // pixels at 854 of width: median of a frame whose camera is well known
constexpr double mostArea = 0.6;     // of the picture: more is no thing that moves, but a camera misjudged
constexpr float stillWeight = 0.02f; // most things stand still
constexpr double leastArea = 0.0015; // of the picture
constexpr float voteDecay = 0.93f;   // a frame

// Distance of the motion from what a still scene can do between two cameras.
double missOfStill(const ShotCamera &from, const ShotCamera &to, const Vec2 &pixel, const Vec2 &seen)
{
    const Eigen::Matrix3d toFromWorld = to.worldFromCamera.linear().transpose();
    const Vec3 far = toFromWorld * from.rayOf(pixel);
    if (far.z() <= 1e-6)
        return 0.0;
    const Vec2 atInfinity = to.centre + to.focal * far.head<2>() / far.z();
    const Vec3 step = toFromWorld * (from.position() - to.position());
    // Where the point goes when it comes nearer: derivative by the inverse depth.
    const Vec2 way = to.focal / (far.z() * far.z()) * (step.head<2>() * far.z() - step.z() * far.head<2>());
    const Vec2 off = seen - atInfinity;
    const double length = way.norm();
    if (length < 1e-9)
        return off.norm();
    const Vec2 along = way / length;
    const double ahead = along.dot(off);
    const double across = std::abs(along.x() * off.y() - along.y() * off.x());
    return ahead < 0.0 ? off.norm() : across;
}

// Where a cell's middle goes to.
std::size_t goal(const CompactFlow &flow, std::size_t cell)
{
    return flow.cellAt(flow.cellMiddle(cell) + flow.cellMotion(cell).cast<double>());
}

// Most of a picture stands still: what it misses by is the cameras' error, or that of the flow in a smeared
// or noisy frame. Where that is more than usual more is needed to be called moving: a factor, at least 1.
double shakiness(const OwnMotion &motion, double unit)
{
    std::vector<float> misses;
    for (std::size_t i = 0; i < motion.pixels.size(); ++i)
        if (motion.trusts[i] > 0.0f)
            misses.push_back(motion.pixels[i]);
    if (misses.empty())
        return 1.0;
    const auto middle = misses.begin() + std::ptrdiff_t(misses.size() / 2);
    std::nth_element(misses.begin(), middle, misses.end());
    return std::max(1.0, double(*middle) / (usualMiss * unit));
}

// Of what came before along the flow a share stays.
void voteFrom(const Shot &shot, int frame, int neighbour, std::vector<float> &sums,
              const std::vector<float> &votes)
{
    const CompactFlow &flow =
        neighbour > frame ? shot.forward[std::size_t(frame)] : shot.backward[std::size_t(neighbour)];
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (flow.cellConfidence(i) >= 0.35f)
            sums[i] += voteDecay * votes[goal(flow, i)];
    }
}

} // namespace

OwnMotion ownMotion(const Shot &shot, int frame)
{
    const CompactFlow &grid = shot.forward.front();
    OwnMotion motion;
    motion.pixels.assign(grid.cellCount(), 0.0f);
    motion.trusts.assign(grid.cellCount(), 0.0f);
    for (int direction : {-1, 1})
        for (const ChainedPlaces &places : chainedFrom(shot, frame, direction * gaps.back())) {
            const int gap = std::abs(places.frame - frame);
            if (std::find(gaps.begin(), gaps.end(), gap) == gaps.end())
                continue;
            for (std::size_t i = 0; i < places.pixels.size(); ++i) {
                if (places.trusts[i] <= 0.0f)
                    continue;
                const double miss =
                    missOfStill(shot.cameras[std::size_t(frame)], shot.cameras[std::size_t(places.frame)],
                                grid.cellMiddle(i), places.pixels[i].cast<double>());
                // Flow's own errors grow with the root of the steps, motions with the steps.
                motion.pixels[i] = std::max(motion.pixels[i], float(miss / std::sqrt(double(gap))));
                motion.trusts[i] = std::max(motion.trusts[i], places.trusts[i]);
            }
        }
    return motion;
}

std::vector<float> movingLikelihood(const OwnMotion &motion, const EdgeWeights &edges, double width)
{
    const double plain = std::max(0.5, width / 854.0), unit = plain * shakiness(motion, plain);
    const std::size_t rowLength = std::size_t(edges.width);
    std::vector<float> likelihoods, weights;
    for (std::size_t i = 0; i < motion.pixels.size(); ++i) {
        // In plain places flow is whatever is around: it tells little.
        float alike = std::min(edges.right[i] > 0.0f ? edges.right[i] : 1.0f,
                               edges.down[i] > 0.0f ? edges.down[i] : 1.0f);
        if (i % rowLength > 0)
            alike = std::min(alike, edges.right[i - 1]);
        if (i >= rowLength)
            alike = std::min(alike, edges.down[i - rowLength]);
        const float weight = motion.trusts[i] * (0.03f + std::max(0.0f, 1.0f - alike));
        const double pixels = double(motion.pixels[i]) / unit;
        const double likelihood = std::clamp((pixels - surelyStill) / (surelyMoving - surelyStill), 0.0, 1.0);
        likelihoods.push_back(float(likelihood) * weight / (weight + stillWeight));
        weights.push_back(weight + stillWeight);
    }
    return smoothed(edges, likelihoods, weights, {6.0, 2});
}

void voteAlongFlow(const Shot &shot, std::vector<std::vector<std::uint8_t>> &likelihoods)
{
    const int frames = int(likelihoods.size());
    std::vector<std::vector<std::uint8_t>> before = likelihoods, after = likelihoods;
    const auto spread = [&](std::vector<std::vector<std::uint8_t>> &votes, int first, int step) {
        std::vector<float> last(votes[std::size_t(first)].begin(), votes[std::size_t(first)].end());
        for (int t = first + step; t >= 0 && t < frames; t += step) {
            std::vector<float> carried(last.size(), 0.0f);
            voteFrom(shot, t, t - step, carried, last);
            shot.forgetPages(t - 1, t);
            for (std::size_t i = 0; i < carried.size(); ++i) {
                // Own evidence and what came along, the stronger one more.
                const float own = float(likelihoods[std::size_t(t)][i]);
                const float mixed = std::max(0.45f * own + 0.55f * carried[i], own);
                last[i] = mixed;
                votes[std::size_t(t)][i] = std::uint8_t(std::clamp(mixed, 0.0f, 255.0f));
            }
        }
    };
    spread(before, 0, 1);
    spread(after, frames - 1, -1);
    for (std::size_t t = 0; t < likelihoods.size(); ++t)
        for (std::size_t i = 0; i < likelihoods[t].size(); ++i)
            likelihoods[t][i] =
                std::uint8_t((int(likelihoods[t][i]) + int(before[t][i]) + int(after[t][i])) / 3);
}

std::vector<std::vector<std::uint8_t>>
numberedObjects(const Shot &shot, const std::vector<std::vector<std::uint8_t>> &likelihoods)
{
    const CompactFlow &grid = shot.forward.front();
    const std::size_t width = std::size_t(grid.width), cells = width * std::size_t(grid.height);
    const std::size_t fewest = std::size_t(leastArea * double(cells)) + 1;
    std::vector<std::vector<std::uint8_t>> numbers;
    int used = 0;
    for (std::size_t t = 0; t < likelihoods.size(); ++t) {
        std::vector<std::uint8_t> now(cells, 0);
        std::vector<bool> isDone(cells, false);
        std::vector<std::uint8_t> expected(cells, 0);
        if (t > 0)
            for (std::size_t i = 0; i < cells; ++i)
                expected[i] = numbers[t - 1][goal(shot.backward[t - 1], i)];
        const auto moving = std::count_if(likelihoods[t].begin(), likelihoods[t].end(),
                                          [](std::uint8_t likelihood) { return likelihood >= 128; });
        for (std::size_t seed = 0; seed < cells && double(moving) <= mostArea * double(cells); ++seed) {
            if (isDone[seed] || likelihoods[t][seed] < 128)
                continue;
            std::vector<std::size_t> group = {seed};
            isDone[seed] = true;
            std::array<int, 256> votes{};
            for (std::size_t k = 0; k < group.size(); ++k) {
                const std::size_t i = group[k];
                ++votes[expected[i]];
                const auto visit = [&](std::size_t j) {
                    if (!isDone[j] && likelihoods[t][j] >= 128) {
                        isDone[j] = true;
                        group.push_back(j);
                    }
                };
                if (i % width > 0)
                    visit(i - 1);
                if (i % width + 1 < width)
                    visit(i + 1);
                if (i >= width)
                    visit(i - width);
                if (i + width < cells)
                    visit(i + width);
            }
            if (group.size() < fewest)
                continue;
            votes[0] = 0;
            int number = int(std::max_element(votes.begin(), votes.end()) - votes.begin());
            if (votes[std::size_t(number)] == 0)
                number = used = used % 255 + 1; // more than 255 are told apart in time
            for (std::size_t i : group)
                now[i] = std::uint8_t(number);
        }
        numbers.push_back(std::move(now));
        shot.forgetPages(int(t), int(t));
    }
    return numbers;
}

} // namespace ductus
