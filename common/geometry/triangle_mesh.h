// TriangleMesh: the one mesh type that crosses folder borders. Indexed triangles, counter-clockwise seen from
// outside; plain data, no invariants beyond valid indices. Connectivity questions go to MeshTopology.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry> // Vec3::cross
#include <array>
#include <vector>

namespace ductus {

using Vec3 = Eigen::Vector3d;
using Triangle = std::array<int, 3>;

struct TriangleMesh
{
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;

    int vertexCount() const { return int(vertices.size()); }
    int triangleCount() const { return int(triangles.size()); }
    bool isEmpty() const { return triangles.empty(); }

    /// Twice the area times the unit normal of triangle \a t.
    Vec3 areaVector(int t) const;
    Vec3 faceNormal(int t) const;
    Vec3 centroid(int t) const;
};

/// Axis-aligned box; empty boxes have min > max.
struct Box3
{
    Vec3 min = Vec3::Constant(1e300);
    Vec3 max = Vec3::Constant(-1e300);

    void add(const Vec3 &point)
    {
        min = min.cwiseMin(point);
        max = max.cwiseMax(point);
    }
    bool isEmpty() const { return min.x() > max.x(); }
    double diagonal() const { return isEmpty() ? 0.0 : (max - min).norm(); }
    Vec3 centre() const { return 0.5 * (min + max); }
};

Box3 boundingBox(const std::vector<Vec3> &points);

/// Area-weighted unit normals, one a vertex; zero for isolated vertices.
std::vector<Vec3> vertexNormals(const TriangleMesh &mesh);

double surfaceArea(const TriangleMesh &mesh);

/// Signed volume enclosed; positive when a closed mesh is oriented outwards.
double signedVolume(const TriangleMesh &mesh);

double meanEdgeLength(const TriangleMesh &mesh);

/// Drops vertices no triangle uses; \a oldFromNew (optional) receives the kept indices.
TriangleMesh compacted(const TriangleMesh &mesh, std::vector<int> *oldFromNew = nullptr);

} // namespace ductus
