// Meshes to and from OBJ, PLY (ascii and binary), STL (ascii and binary), OFF and GLB, chosen by extension for
// writing and by content for reading. Polygons are fanned into triangles.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"

#include <filesystem>
#include <string>

namespace ductus {

/// What can be written beside the triangles.
struct MeshFileContent
{
    TriangleMesh mesh;
    std::vector<int> triangleRegions; // region number >= 0 of each triangle, or empty. OBJ: groups "region_N";
                                      // PLY: face property int region; GLB: one primitive a region
    std::vector<std::vector<int>> featureLines; // polylines of vertex indices; OBJ: "l" records in group "features"
    std::string comment;              // one line, where the format has room
};

Result<TriangleMesh> readMesh(const std::filesystem::path &path, const JobControl &control);

/// Writes beside the target and renames, so that a failure or cancel leaves no file and no half of one.
Result<void> writeMesh(const MeshFileContent &content, const std::filesystem::path &path, const JobControl &control);

/// True if writeMesh knows the extension.
bool isMeshExtension(const std::filesystem::path &path);

} // namespace ductus
