#include "surfacing/proxy/point_subset.h"

#include "geometry/point_tree.h"

#include <algorithm>

namespace ductus {

std::vector<int> farthestPoints(const std::vector<Vec3> &points, int count, double minDistance)
{
    std::vector<int> chosen;
    if (points.empty() || count <= 0)
        return chosen;
    Vec3 centroid = Vec3::Zero();
    for (const Vec3 &p : points)
        centroid += p / double(points.size());
    std::vector<double> squaredDistance(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        squaredDistance[i] = (points[i] - centroid).squaredNorm();
    std::size_t next = std::size_t(std::max_element(squaredDistance.begin(), squaredDistance.end()) -
                                   squaredDistance.begin());
    std::fill(squaredDistance.begin(), squaredDistance.end(), 1e300);
    while (int(chosen.size()) < count) {
        chosen.push_back(int(next));
        std::size_t farthest = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            squaredDistance[i] = std::min(squaredDistance[i], (points[i] - points[next]).squaredNorm());
            if (squaredDistance[i] > squaredDistance[farthest])
                farthest = i;
        }
        if (squaredDistance[farthest] <= minDistance * minDistance)
            break;
        next = farthest;
    }
    return chosen;
}

std::vector<Vec3> spreadOut(const std::vector<Vec3> &points, double minDistance)
{
    const PointTree tree(points);
    std::vector<char> isTaken(points.size(), 0);
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (isTaken[i])
            continue;
        for (int j : tree.within(points[i], minDistance))
            isTaken[std::size_t(j)] = 1;
        kept.push_back(points[i]);
    }
    return kept;
}

double medianSpacing(const std::vector<Vec3> &points)
{
    if (points.size() < 2)
        return 0.0;
    const PointTree tree(points);
    std::vector<double> spacings;
    for (const Vec3 &p : points)
        spacings.push_back((points[std::size_t(tree.nearest(p, 2).back())] - p).norm());
    std::nth_element(spacings.begin(), spacings.begin() + std::ptrdiff_t(spacings.size() / 2), spacings.end());
    return spacings[spacings.size() / 2];
}

} // namespace ductus
