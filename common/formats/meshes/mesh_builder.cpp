#include "formats/meshes/mesh_builder.h"

#include "formats/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ductus {

std::optional<MeshBuilder::Fault> MeshBuilder::addVertex(const Vec3 &position)
{
    for (int k = 0; k < 3; ++k)
        if (!(std::abs(position[k]) <= largestCoordinate))
            return Fault{
                ErrorCode::Malformed,
                std::string("the ") + "xyz"[k] + " coordinate of vertex " + std::to_string(vertexCount()) +
                    (std::isfinite(position[k]) ? " is too large a number" : " is not a finite number"),
                "Repair the mesh or export it again"};
    if (vertexCount() >= mostMeshVertices)
        return Fault{ErrorCode::TooLarge,
                     "the mesh has more than the " + std::to_string(mostMeshVertices) +
                         " vertices that are taken",
                     "Simplify the mesh first"};
    mMesh.vertices.push_back(position);
    return std::nullopt;
}

std::optional<MeshBuilder::Fault> MeshBuilder::addVertex(const Vec3 &position, const Eigen::Vector4f &colour)
{
    if (std::optional<Fault> fault = addVertex(position))
        return fault;
    mColours.push_back(colour);
    return std::nullopt;
}

std::optional<MeshBuilder::Fault> MeshBuilder::addPolygon(std::span<const std::int64_t> corners)
{
    if (corners.size() < 3)
        return Fault{ErrorCode::Malformed, "a face has " + std::to_string(corners.size()) + " corners",
                     "Remove the face or export the mesh again"};
    for (const std::int64_t corner : corners)
        if (corner < 0 || corner >= vertexCount())
            return Fault{ErrorCode::Malformed,
                         "a face uses vertex " + std::to_string(corner) +
                             " (counted from 0), but there are " + std::to_string(vertexCount()) +
                             " vertices",
                         "Repair the mesh or export it again"};
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        const Triangle triangle{int(corners[0]), int(corners[k]), int(corners[k + 1])};
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
            continue;
        if (std::int64_t(mMesh.triangles.size()) >= mostMeshTriangles)
            return Fault{ErrorCode::TooLarge,
                         "the mesh has more than the " + std::to_string(mostMeshTriangles) +
                             " triangles that are taken",
                         "Simplify the mesh first"};
        mMesh.triangles.push_back(triangle);
    }
    return std::nullopt;
}

void MeshBuilder::mergeEqualVertices()
{
    const std::vector<Vec3> &vertices = mMesh.vertices;
    const auto key = [&](int v) {
        const Vec3 &p = vertices[std::size_t(v)];
        std::array<double, 7> numbers{p.x(), p.y(), p.z()};
        if (!mColours.empty())
            std::copy_n(mColours[std::size_t(v)].data(), 4, numbers.begin() + 3);
        return numbers;
    };
    std::vector<int> order(vertices.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
    std::vector<int> first(vertices.size()); // of the equal vertices, the first in file order
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
        first[std::size_t(order[i])] = same ? first[std::size_t(order[i - 1])] : order[i];
    }
    TriangleMesh merged;
    std::vector<Eigen::Vector4f> colours;
    std::vector<int> newFromOld(vertices.size());
    for (int v = 0; v < mMesh.vertexCount(); ++v) {
        if (first[std::size_t(v)] == v) {
            newFromOld[std::size_t(v)] = merged.vertexCount();
            merged.vertices.push_back(vertices[std::size_t(v)]);
            if (!mColours.empty())
                colours.push_back(mColours[std::size_t(v)]);
        } else {
            newFromOld[std::size_t(v)] = newFromOld[std::size_t(first[std::size_t(v)])];
        }
    }
    for (const Triangle &t : mMesh.triangles) {
        const Triangle mapped{newFromOld[std::size_t(t[0])], newFromOld[std::size_t(t[1])],
                              newFromOld[std::size_t(t[2])]};
        if (mapped[0] != mapped[1] && mapped[1] != mapped[2] && mapped[2] != mapped[0])
            merged.triangles.push_back(mapped);
    }
    mMesh = std::move(merged);
    mColours = std::move(colours);
}

Result<TriangleMesh> MeshBuilder::finish(const std::string &name)
{
    if (mMesh.triangles.empty())
        return Error{ErrorCode::TooLittleData, readingTheMesh, "there are no triangles in it",
                     "Export a mesh with faces", name};
    return std::move(mMesh);
}

Result<ColouredMesh> MeshBuilder::finishColoured(const std::string &name)
{
    Result<TriangleMesh> mesh = finish(name);
    if (!mesh)
        return mesh.error();
    return ColouredMesh{std::move(*mesh), std::move(mColours)};
}

} // namespace ductus
