#include "geometry/inspection/ray_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ductus {

namespace {

constexpr int leafSize = 4;

// Slab test; distance at which the ray enters, or infinity.
double entry(const Box3 &box, const Vec3 &origin, const Vec3 &inverse, double farthest)
{
    double from = 0.0, to = farthest;
    for (int axis = 0; axis < 3; ++axis) {
        const double t0 = (box.min[axis] - origin[axis]) * inverse[axis];
        const double t1 = (box.max[axis] - origin[axis]) * inverse[axis];
        from = std::max(from, std::min(t0, t1));
        to = std::min(to, std::max(t0, t1));
    }
    return from <= to ? from : INFINITY;
}

} // namespace

RayTree::RayTree(const TriangleMesh &mesh)
{
    std::vector<Vec3> centres;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Triangle &corners = mesh.triangles[std::size_t(t)];
        const Vec3 &a = mesh.vertices[std::size_t(corners[0])];
        mCorners.push_back(
            {a, mesh.vertices[std::size_t(corners[1])] - a, mesh.vertices[std::size_t(corners[2])] - a});
        centres.push_back(mesh.centroid(t));
    }
    if (mCorners.empty())
        return;
    mOrder.resize(mCorners.size());
    std::iota(mOrder.begin(), mOrder.end(), 0);
    mNodes.reserve(mCorners.size());
    build(0, int(mOrder.size()), centres);
}

int RayTree::build(int begin, int end, const std::vector<Vec3> &centres)
{
    const int index = int(mNodes.size());
    mNodes.emplace_back();
    Box3 box, middle;
    for (int i = begin; i < end; ++i) {
        const Corners &c = mCorners[std::size_t(mOrder[std::size_t(i)])];
        box.add(c.a);
        box.add(c.a + c.ab);
        box.add(c.a + c.ac);
        middle.add(centres[std::size_t(mOrder[std::size_t(i)])]);
    }
    mNodes[std::size_t(index)].box = box;
    if (end - begin <= leafSize) {
        mNodes[std::size_t(index)].first = begin;
        mNodes[std::size_t(index)].count = end - begin;
        return index;
    }
    int axis = 0;
    (middle.max - middle.min).maxCoeff(&axis);
    const int half = (begin + end) / 2;
    std::nth_element(mOrder.begin() + begin, mOrder.begin() + half, mOrder.begin() + end, [&](int a, int b) {
        const double x = centres[std::size_t(a)][axis], y = centres[std::size_t(b)][axis];
        return x < y || (x == y && a < b);
    });
    build(begin, half, centres);
    const int second = build(half, end, centres);
    mNodes[std::size_t(index)].first = second;
    return index;
}

int RayTree::traverse(const Vec3 &origin, const Vec3 &direction, double nearest, double &farthest,
                      bool anyHit) const
{
    if (mNodes.empty())
        return -1;
    const Vec3 inverse = direction.cwiseInverse();
    int found = -1;
    int stack[64];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const int index = stack[--depth];
        const Node &node = mNodes[std::size_t(index)];
        if (entry(node.box, origin, inverse, farthest) == INFINITY)
            continue;
        if (node.count == 0) {
            const double first = entry(mNodes[std::size_t(index + 1)].box, origin, inverse, farthest);
            const double second = entry(mNodes[std::size_t(node.first)].box, origin, inverse, farthest);
            const bool firstIsNearer = first <= second;
            stack[depth++] = firstIsNearer ? node.first : index + 1;
            stack[depth++] = firstIsNearer ? index + 1 : node.first;
            continue;
        }
        for (int i = node.first; i < node.first + node.count; ++i) {
            // [Moeller, Trumbore 1997]
            const int triangle = mOrder[std::size_t(i)];
            const Corners &c = mCorners[std::size_t(triangle)];
            const Vec3 p = direction.cross(c.ac);
            const double determinant = c.ab.dot(p);
            if (determinant == 0.0)
                continue;
            const Vec3 s = origin - c.a;
            const double u = s.dot(p) / determinant;
            if (!(u >= 0.0 && u <= 1.0))
                continue;
            const Vec3 q = s.cross(c.ab);
            const double v = direction.dot(q) / determinant;
            if (!(v >= 0.0 && u + v <= 1.0))
                continue;
            const double t = c.ac.dot(q) / determinant;
            if (t > nearest && t < farthest) {
                farthest = t;
                found = triangle;
                if (anyHit)
                    return found;
            }
        }
    }
    return found;
}

std::optional<RayHit> RayTree::firstHit(const Vec3 &origin, const Vec3 &direction, double nearest) const
{
    RayHit hit;
    hit.distance = INFINITY;
    hit.triangle = traverse(origin, direction, nearest, hit.distance, false);
    if (hit.triangle < 0)
        return std::nullopt;
    hit.point = origin + hit.distance * direction;
    const Corners &c = mCorners[std::size_t(hit.triangle)];
    hit.normal = c.ab.cross(c.ac).normalized();
    if (hit.normal.dot(direction) > 0.0)
        hit.normal = -hit.normal;
    return hit;
}

bool RayTree::isBlocked(const Vec3 &origin, const Vec3 &direction, double nearest, double farthest) const
{
    return traverse(origin, direction, nearest, farthest, true) >= 0;
}

} // namespace ductus
