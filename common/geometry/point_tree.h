// Nearest points of a point set: a balanced k-d tree. Equal distances are ordered by index, so that answers
// do not depend on how the tree was built.
#pragma once

#include "geometry/triangle_mesh.h"

namespace ductus {

class PointTree
{
public:
    explicit PointTree(std::vector<Vec3> points);

    /// Indices of the \a count nearest points, nearest first; fewer if there are fewer.
    std::vector<int> nearest(const Vec3 &query, int count) const;

    /// Indices of all points no farther than \a radius, ascending.
    std::vector<int> within(const Vec3 &query, double radius) const;

    const std::vector<Vec3> &points() const { return mPoints; }

private:
    void split(int begin, int end, int axis);

    std::vector<Vec3> mPoints;
    std::vector<int> mOrder; // of a range its middle is the node, the halves are its children
};

} // namespace ductus
