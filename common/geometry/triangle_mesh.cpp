#include "geometry/triangle_mesh.h"

namespace ductus {

Vec3 TriangleMesh::areaVector(int t) const
{
    const Triangle &tri = triangles[t];
    return (vertices[tri[1]] - vertices[tri[0]]).cross(vertices[tri[2]] - vertices[tri[0]]);
}

Vec3 TriangleMesh::faceNormal(int t) const
{
    return areaVector(t).normalized();
}

Vec3 TriangleMesh::centroid(int t) const
{
    const Triangle &tri = triangles[t];
    return (vertices[tri[0]] + vertices[tri[1]] + vertices[tri[2]]) / 3.0;
}

Box3 boundingBox(const std::vector<Vec3> &points)
{
    Box3 box;
    for (const Vec3 &p : points)
        box.add(p);
    return box;
}

std::vector<Vec3> vertexNormals(const TriangleMesh &mesh)
{
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Vec3 area = mesh.areaVector(t);
        for (int v : mesh.triangles[t])
            normals[v] += area;
    }
    for (Vec3 &n : normals) {
        const double length = n.norm();
        n = length > 0.0 ? Vec3(n / length) : Vec3(Vec3::Zero());
    }
    return normals;
}

double surfaceArea(const TriangleMesh &mesh)
{
    double twice = 0.0;
    for (int t = 0; t < mesh.triangleCount(); ++t)
        twice += mesh.areaVector(t).norm();
    return 0.5 * twice;
}

double signedVolume(const TriangleMesh &mesh)
{
    double six = 0.0;
    for (const Triangle &t : mesh.triangles)
        six += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
    return six / 6.0;
}

double meanEdgeLength(const TriangleMesh &mesh)
{
    double sum = 0.0;
    for (const Triangle &t : mesh.triangles)
        for (int k = 0; k < 3; ++k)
            sum += (mesh.vertices[t[k]] - mesh.vertices[t[(k + 1) % 3]]).norm();
    return mesh.isEmpty() ? 0.0 : sum / (3.0 * mesh.triangleCount());
}

TriangleMesh compacted(const TriangleMesh &mesh, std::vector<int> *oldFromNew)
{
    TriangleMesh result;
    std::vector<int> newFromOld(mesh.vertices.size(), -1);
    std::vector<char> used(mesh.vertices.size(), 0);
    for (const Triangle &t : mesh.triangles)
        for (int v : t)
            used[v] = 1;
    if (oldFromNew)
        oldFromNew->clear();
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (!used[v])
            continue;
        newFromOld[v] = result.vertexCount();
        result.vertices.push_back(mesh.vertices[v]);
        if (oldFromNew)
            oldFromNew->push_back(v);
    }
    result.triangles.reserve(mesh.triangles.size());
    for (const Triangle &t : mesh.triangles)
        result.triangles.push_back({newFromOld[t[0]], newFromOld[t[1]], newFromOld[t[2]]});
    return result;
}

} // namespace ductus
