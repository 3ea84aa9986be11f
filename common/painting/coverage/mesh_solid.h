// A mesh of a painting in the scene: what rays meet, what is inside, what is near.
#pragma once

#include "painting/coverage/box_tree.h"
#include "painting/scene/element.h"

#include <optional>

namespace ductus {

struct MeshHit
{
    double s = 0;
    int triangle = -1;
    Vec3 barycentric = Vec3::Zero();
};

class MeshSolid
{
public:
    MeshSolid(const MeshShape &shape, const Eigen::Affine3d &sceneFromElement);

    /// First triangle, from either side, at s >= from and s < limit.
    std::optional<MeshHit> hit(const Vec3 &origin, const Vec3 &direction, double from, double limit) const;

    /// Whether the surface winds around \a x: triangles that look away from x less those that look towards
    /// it, along a ray, are not 0. For closed meshes with either winding; meaningless for open ones.
    bool contains(const Vec3 &x) const;

    /// Nearest place no further than \a limit; s is the distance.
    std::optional<MeshHit> nearest(const Vec3 &x, double limit) const;

    Vec3 normal(int triangle) const { return mMesh.faceNormal(triangle); }
    Vec3 point(const MeshHit &hit) const;
    /// Linear RGB between the vertices' colours.
    Eigen::Vector3f colour(const MeshHit &hit) const;
    /// The mean of the vertices' colours: what a mesh colours with in an appearance layer.
    const Eigen::Vector3f &meanColour() const { return mMeanColour; }
    const TriangleMesh &mesh() const { return mMesh; } // in the scene
    const std::vector<Eigen::Vector3f> &vertexColours() const { return mColours; }
    const Box3 &box() const { return mBox; }

private:
    TriangleMesh mMesh;
    std::vector<Eigen::Vector3f> mColours;
    Eigen::Vector3f mMeanColour = Eigen::Vector3f::Zero();
    Box3 mBox;
    BoxTree mTree;
};

} // namespace ductus
