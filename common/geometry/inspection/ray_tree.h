// RayTree: where a ray first meets a mesh. A tree of boxes, read-only after it was made, so any number of
// threads may ask at once: the pointer on the UI thread, ambient light and wall thickness on workers.
#pragma once

#include "geometry/triangle_mesh.h"

#include <optional>

namespace ductus {

struct RayHit
{
    int triangle = -1;
    double distance = 0.0; // along the ray's unit direction
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ(); // of the triangle, unit, turned towards the ray's origin
};

class RayTree
{
public:
    RayTree() = default;
    /// Copies the corners; triangles without area are never hit.
    explicit RayTree(const TriangleMesh &mesh);

    bool isEmpty() const { return mNodes.empty(); }
    /// Both sides of triangles are hit, if they are further than \a nearest along the ray.
    std::optional<RayHit> firstHit(const Vec3 &origin, const Vec3 &direction, double nearest = 0.0) const;
    /// Whether anything lies between \a nearest and \a farthest along the ray.
    bool isBlocked(const Vec3 &origin, const Vec3 &direction, double nearest, double farthest) const;

private:
    struct Node
    {
        Box3 box;
        int first = 0; // leaf: of mOrder; inner: index of the second child (the first follows its parent)
        int count = 0; // of triangles; 0 for inner nodes
    };
    struct Corners
    {
        Vec3 a, ab, ac;
    };

    int build(int begin, int end, const std::vector<Vec3> &centres);
    // Nearest hit in (nearest, farthest); any hit if \a anyHit.
    int traverse(const Vec3 &origin, const Vec3 &direction, double nearest, double &farthest,
                 bool anyHit) const;

    std::vector<Node> mNodes;
    std::vector<int> mOrder; // triangle numbers, leaf by leaf
    std::vector<Corners> mCorners;
};

} // namespace ductus
