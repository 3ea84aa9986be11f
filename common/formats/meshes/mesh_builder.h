// The checks every mesh reader needs: finite vertices, valid indices, bounded sizes, polygons fanned.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "formats/mesh_file.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace ductus {

inline constexpr const char *readingTheMesh = "Reading the mesh";

/// No file may make more than this, however its parts repeat (GLB nodes can place one mesh many times).
constexpr std::int64_t mostMeshVertices = 20'000'000;
constexpr std::int64_t mostMeshTriangles = 40'000'000;

class MeshBuilder
{
public:
    /// What is wrong with the input; place and file are the reader's to add.
    struct Fault
    {
        ErrorCode code = ErrorCode::Malformed;
        std::string problem;
        std::string remedy;

        Error at(std::string place) const
        {
            return {code, readingTheMesh, problem, remedy, std::move(place)};
        }
    };

    std::int64_t vertexCount() const { return std::int64_t(mMesh.vertices.size()); }

    std::optional<Fault> addVertex(const Vec3 &position);
    /// Either all vertices have colours or none.
    std::optional<Fault> addVertex(const Vec3 &position, const Eigen::Vector4f &colour);

    /// Fans the polygon from its first corner; triangles with a corner twice are left out.
    std::optional<Fault> addPolygon(std::span<const std::int64_t> corners);

    /// Merges vertices at exactly the same place (0 equals -0) and of the same colour; the first one stays.
    void mergeEqualVertices();

    /// The mesh, or TooLittleData if there are no triangles. \a name of the file.
    Result<TriangleMesh> finish(const std::string &name);
    Result<ColouredMesh> finishColoured(const std::string &name);

private:
    TriangleMesh mMesh;
    std::vector<Eigen::Vector4f> mColours; // as many as vertices, or none
};

} // namespace ductus
