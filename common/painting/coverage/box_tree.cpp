#include "painting/coverage/box_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ductus {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int leafSize = 4;

bool touch(const Box3 &a, const Box3 &b)
{
    return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

/// Where the ray enters the box, at least 0; infinity if it misses.
double entry(const Box3 &box, const Vec3 &origin, const Vec3 &inverse)
{
    double from = 0, to = infinity;
    for (int i = 0; i < 3; ++i) {
        if (std::isinf(inverse[i])) { // along the slab: inside or not
            if (origin[i] < box.min[i] || origin[i] > box.max[i])
                return infinity;
            continue;
        }
        const double a = (box.min[i] - origin[i]) * inverse[i], b = (box.max[i] - origin[i]) * inverse[i];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    // Rounding must not lose what lies in a box without thickness.
    return from <= to + 1e-9 * std::abs(to) ? from : infinity;
}

double distanceTo(const Box3 &box, const Vec3 &point)
{
    return (box.min - point).cwiseMax(point - box.max).cwiseMax(0).norm();
}

} // namespace

BoxTree::BoxTree(const std::vector<Box3> &boxes)
{
    for (int i = 0; i < int(boxes.size()); ++i)
        if (!boxes[std::size_t(i)].isEmpty())
            mOrder.push_back(i);
    if (!mOrder.empty())
        build(boxes, 0, int(mOrder.size()));
}

int BoxTree::build(const std::vector<Box3> &boxes, int begin, int end)
{
    const int index = int(mNodes.size());
    mNodes.emplace_back();
    Box3 box, centres;
    for (int i = begin; i < end; ++i) {
        const Box3 &one = boxes[std::size_t(mOrder[std::size_t(i)])];
        box.add(one.min);
        box.add(one.max);
        centres.add(one.centre());
    }
    mNodes[std::size_t(index)].box = box;
    if (end - begin <= leafSize) {
        mNodes[std::size_t(index)].first = begin;
        mNodes[std::size_t(index)].count = end - begin;
        return index;
    }
    Eigen::Index axis = 0;
    (centres.max - centres.min).maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    std::nth_element(mOrder.begin() + begin, mOrder.begin() + middle, mOrder.begin() + end,
                     [&](int a, int b) {
                         const double ca = boxes[std::size_t(a)].centre()[axis];
                         const double cb = boxes[std::size_t(b)].centre()[axis];
                         return ca != cb ? ca < cb : a < b;
                     });
    build(boxes, begin, middle);
    const int right = build(boxes, middle, end);
    mNodes[std::size_t(index)].first = right;
    return index;
}

void BoxTree::forBox(const Box3 &query, const std::function<void(int)> &visit) const
{
    if (mNodes.empty())
        return;
    std::array<int, 64> stack{0};
    for (int size = 1; size > 0;) {
        const int index = stack[std::size_t(--size)];
        const Node &node = mNodes[std::size_t(index)];
        if (!touch(node.box, query))
            continue;
        for (int i = 0; i < node.count; ++i)
            visit(mOrder[std::size_t(node.first + i)]);
        if (node.count == 0) {
            stack[std::size_t(size++)] = node.first;
            stack[std::size_t(size++)] = index + 1;
        }
    }
}

void BoxTree::forRay(const Vec3 &origin, const Vec3 &direction, double limit,
                     const std::function<double(int)> &visit) const
{
    if (mNodes.empty())
        return;
    const Vec3 inverse = direction.cwiseInverse();
    std::array<std::pair<double, int>, 64> stack;
    stack[0] = {entry(mNodes[0].box, origin, inverse), 0};
    for (int size = 1; size > 0;) {
        const auto [at, index] = stack[std::size_t(--size)];
        if (!(at <= limit) || at == infinity)
            continue;
        const Node &node = mNodes[std::size_t(index)];
        for (int i = 0; i < node.count; ++i)
            limit = visit(mOrder[std::size_t(node.first + i)]);
        if (node.count > 0)
            continue;
        const double left = entry(mNodes[std::size_t(index + 1)].box, origin, inverse);
        const double right = entry(mNodes[std::size_t(node.first)].box, origin, inverse);
        const std::pair<double, int> l{left, index + 1}, r{right, node.first};
        stack[std::size_t(size++)] = left <= right ? r : l;
        stack[std::size_t(size++)] = left <= right ? l : r;
    }
}

void BoxTree::forNear(const Vec3 &point, double limit, const std::function<double(int)> &visit) const
{
    if (mNodes.empty())
        return;
    std::array<std::pair<double, int>, 64> stack;
    stack[0] = {distanceTo(mNodes[0].box, point), 0};
    for (int size = 1; size > 0;) {
        const auto [at, index] = stack[std::size_t(--size)];
        if (!(at <= limit))
            continue;
        const Node &node = mNodes[std::size_t(index)];
        for (int i = 0; i < node.count; ++i)
            limit = visit(mOrder[std::size_t(node.first + i)]);
        if (node.count > 0)
            continue;
        const double left = distanceTo(mNodes[std::size_t(index + 1)].box, point);
        const double right = distanceTo(mNodes[std::size_t(node.first)].box, point);
        const std::pair<double, int> l{left, index + 1}, r{right, node.first};
        stack[std::size_t(size++)] = left <= right ? r : l;
        stack[std::size_t(size++)] = left <= right ? l : r;
    }
}

} // namespace ductus
