#include "surfacing/proxy/point_subset.h"

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

} // namespace ductus
