// A tree of boxes: which of many things are near a point, in a box, along a ray.
#pragma once

#include "geometry/triangle_mesh.h"

#include <functional>

namespace ductus {

class BoxTree
{
public:
    BoxTree() = default;
    /// Numbers of things are their places in \a boxes; empty boxes are never found.
    explicit BoxTree(const std::vector<Box3> &boxes);

    bool isEmpty() const { return mNodes.empty(); }

    /// Calls visit(thing) once for all whose box touches \a query, and for some near by: leaves are not
    /// looked into. So do the others.
    void forBox(const Box3 &query, const std::function<void(int)> &visit) const;

    /// Calls visit(thing) for all whose box the ray enters at most \a limit away, roughly from near to far;
    /// limit = visit(...) from then on, so that the nearest hit ends the search.
    void forRay(const Vec3 &origin, const Vec3 &direction, double limit,
                const std::function<double(int)> &visit) const;

    /// Calls visit(thing) for all whose box is at most \a limit (a distance) from \a point, nearest branch
    /// first; limit = visit(...).
    void forNear(const Vec3 &point, double limit, const std::function<double(int)> &visit) const;

private:
    struct Node
    {
        Box3 box;
        int first = 0; // of leaves: range of mOrder; else the right child (the left one follows its parent)
        int count = 0; // 0: not a leaf
    };

    int build(const std::vector<Box3> &boxes, int begin, int end);

    std::vector<Node> mNodes;
    std::vector<int> mOrder;
};

} // namespace ductus
