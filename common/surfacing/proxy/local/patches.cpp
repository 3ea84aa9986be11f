#include "surfacing/proxy/local/patches.h"

#include "base/parallel.h"
#include "surfacing/proxy/point_subset.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

std::vector<Vec3> placesOf(const std::vector<int> &indices, const std::vector<Vec3> &points)
{
    std::vector<Vec3> places;
    for (int i : indices)
        places.push_back(points[std::size_t(i)]);
    return places;
}

// Second principal spread as a share of the first.
double widthOf(const std::vector<Vec3> &points)
{
    Vec3 mean = Vec3::Zero();
    for (const Vec3 &p : points)
        mean += p / double(points.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3 &p : points)
        spread += (p - mean) * (p - mean).transpose();
    const Vec3 moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues();
    return moments[2] > 0.0 ? std::sqrt(std::max(0.0, moments[1]) / moments[2]) : 0.0;
}

Patch patchAround(const PointTree &tree, int centre, const PatchOptions &options)
{
    Patch patch;
    patch.centre = tree.points()[std::size_t(centre)];
    std::vector<int> ball;
    std::vector<Vec3> places;
    for (int growth = 1; growth <= options.mostGrowth; growth *= 2) {
        ball = tree.nearest(patch.centre, growth * options.points);
        places = placesOf(ball, tree.points());
        if (widthOf(places) >= options.leastWidth || int(ball.size()) < growth * options.points)
            break;
    }
    patch.radius = (places.back() - patch.centre).norm();
    if (int(ball.size()) <= options.points)
        patch.members = ball;
    else
        for (int i : farthestPoints(places, options.points, 0.0))
            patch.members.push_back(ball[std::size_t(i)]);
    std::sort(patch.members.begin(), patch.members.end());
    return patch;
}

} // namespace

std::vector<Patch> coverWithPatches(const PointTree &tree, const PatchOptions &options)
{
    // Which points start patches is decided in order; the patches of a batch are made side by side, and those
    // whose centre another of the batch covers are dropped again.
    constexpr std::size_t batchSize = 64;
    std::vector<Patch> patches;
    std::vector<char> isCovered(tree.points().size(), 0);
    std::size_t next = 0;
    while (next < isCovered.size()) {
        std::vector<int> centres;
        for (; next < isCovered.size() && centres.size() < batchSize; ++next)
            if (!isCovered[next])
                centres.push_back(int(next));
        std::vector<Patch> batch(centres.size());
        parallelFor(0, centres.size(),
                    [&](std::size_t i) { batch[i] = patchAround(tree, centres[i], options); });
        for (std::size_t i = 0; i < batch.size(); ++i) {
            if (isCovered[std::size_t(centres[i])] || !(batch[i].radius > 0.0))
                continue;
            for (int p : tree.within(batch[i].centre, options.coverShare * batch[i].radius))
                isCovered[std::size_t(p)] = 1;
            patches.push_back(std::move(batch[i]));
        }
    }
    return patches;
}

} // namespace ductus
