#include "geometry/point_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ductus {

namespace {

using Candidate = std::pair<double, int>; // squared distance, index

// Visits the nodes of a range, the side of the query first; reach() is the squared distance still of
// interest.
template <typename Reach, typename Visit>
void descend(const std::vector<Vec3> &points, const std::vector<int> &order, int begin, int end, int axis,
             const Vec3 &query, const Reach &reach, const Visit &visit)
{
    if (begin >= end)
        return;
    const int middle = begin + (end - begin) / 2;
    const int node = order[std::size_t(middle)];
    const double toPlane = query[axis] - points[std::size_t(node)][axis];
    const int next = (axis + 1) % 3;
    visit({(query - points[std::size_t(node)]).squaredNorm(), node});
    const auto side = [&](bool upper) {
        if (upper)
            descend(points, order, middle + 1, end, next, query, reach, visit);
        else
            descend(points, order, begin, middle, next, query, reach, visit);
    };
    side(toPlane > 0.0);
    if (toPlane * toPlane <= reach())
        side(!(toPlane > 0.0));
}

} // namespace

PointTree::PointTree(std::vector<Vec3> points) : mPoints(std::move(points)), mOrder(mPoints.size())
{
    std::iota(mOrder.begin(), mOrder.end(), 0);
    split(0, int(mOrder.size()), 0);
}

void PointTree::split(int begin, int end, int axis)
{
    if (end - begin < 2)
        return;
    const int middle = begin + (end - begin) / 2;
    std::nth_element(mOrder.begin() + begin, mOrder.begin() + middle, mOrder.begin() + end,
                     [&](int a, int b) {
                         return std::make_pair(mPoints[std::size_t(a)][axis], a) <
                                std::make_pair(mPoints[std::size_t(b)][axis], b);
                     });
    split(begin, middle, (axis + 1) % 3);
    split(middle + 1, end, (axis + 1) % 3);
}

std::vector<int> PointTree::nearest(const Vec3 &query, int count) const
{
    if (count <= 0)
        return {};
    std::vector<Candidate> best; // a heap, farthest on top
    const auto reach = [&] { return int(best.size()) < count ? 1e300 : best.front().first; };
    descend(mPoints, mOrder, 0, int(mOrder.size()), 0, query, reach, [&](const Candidate &candidate) {
        if (int(best.size()) == count) {
            if (!(candidate < best.front()))
                return;
            std::pop_heap(best.begin(), best.end());
            best.pop_back();
        }
        best.push_back(candidate);
        std::push_heap(best.begin(), best.end());
    });
    std::sort_heap(best.begin(), best.end());
    std::vector<int> indices;
    for (const Candidate &candidate : best)
        indices.push_back(candidate.second);
    return indices;
}

std::vector<int> PointTree::within(const Vec3 &query, double radius) const
{
    const double squared = radius * radius;
    std::vector<int> indices;
    descend(
        mPoints, mOrder, 0, int(mOrder.size()), 0, query, [&] { return squared; },
        [&](const Candidate &candidate) {
            if (candidate.first <= squared)
                indices.push_back(candidate.second);
        });
    std::sort(indices.begin(), indices.end());
    return indices;
}

} // namespace ductus
