// Nearest-point queries on a triangle mesh (CGAL AABB tree behind a narrow interface).
#pragma once

#include "geometry/triangle_mesh.h"

#include <memory>

namespace ductus {

struct NearestPoint
{
    Vec3 point = Vec3::Zero();
    int triangle = -1;
    Vec3 barycentric = Vec3::Zero(); // of point in that triangle; sums to 1, each >= 0
    double distance = 0.0;
};

class NearestOnMesh
{
public:
    /// Copies what it needs; triangles without area are left out. The mesh must have at least one with area.
    explicit NearestOnMesh(const TriangleMesh &mesh);
    ~NearestOnMesh();
    NearestOnMesh(NearestOnMesh &&) noexcept;

    /// May be called from several threads at once. Ties are broken the same way every time.
    NearestPoint nearest(const Vec3 &query) const;

    /// True if \a query lies inside a closed, outwards oriented mesh. Meaningless for open ones.
    bool isInside(const Vec3 &query) const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> mImplementation;
};

} // namespace ductus
