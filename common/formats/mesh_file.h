// Meshes to and from OBJ, PLY (ascii and binary), STL (ascii and binary), OFF and GLB, chosen by extension
// for writing and by content for reading. Polygons are fanned into triangles.
#pragma once

#include "base/job_control.h"
#include "base/result.h"
#include "geometry/triangle_mesh.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ductus {

/// What can be written beside the triangles.
struct MeshFileContent
{
    TriangleMesh mesh;
    std::vector<int>
        triangleRegions; // region number >= 0 of each triangle, or empty. OBJ: groups "region_N";
                         // PLY: face property int region; GLB: one primitive a region
    std::vector<std::vector<int>>
        featureLines;    // polylines of vertex indices; OBJ: "l" records in group "features"
    std::string comment; // one line, where the format has room
    std::vector<Eigen::Vector4f> vertexColours; // linear RGB and opacity, 0..1, one a vertex, or empty. GLB
                                                // only: COLOR_0 of unlit materials; the others leave them out
    std::vector<std::string> regionNames; // UTF-8, of region 0, 1, ..., or empty. GLB: a node of that name
                                          // for each region instead of one node for all
};

struct ColouredMesh
{
    TriangleMesh mesh;
    std::vector<Eigen::Vector4f> vertexColours; // linear RGB and opacity, 0..1, one a vertex; empty without
};

/// Errors say file and line, or file and byte. STL and GLB store corners many times: equal positions are
/// merged there. Triangles with a corner twice are left out; a file without any other is TooLittleData.
Result<TriangleMesh> readMesh(const std::filesystem::path &path, const JobControl &control);

/// With the colours of GLB's vertices and materials (not of textures); meshes of other formats come without.
/// Vertices at the same place stay apart where their colours differ.
Result<ColouredMesh> readColouredMesh(const std::filesystem::path &path, const JobControl &control);

/// The same as readMesh from memory; \a name stands for the file in messages.
Result<TriangleMesh> parseMesh(std::string_view bytes, const std::string &name, const JobControl &control);

/// Writes beside the target and renames, so that a failure or cancel leaves no file and no half of one. STL
/// and GLB hold 32-bit floats, the others keep every bit. GLB is y-up and in metres: hand in such
/// coordinates. Same content, same bytes. InvalidArgument for an unknown extension, indices out of range or
/// numbers that are not finite.
Result<void> writeMesh(const MeshFileContent &content, const std::filesystem::path &path,
                       const JobControl &control);

/// What writeMesh would write to a file with \a extension (".obj", in any case).
Result<std::string> meshBytes(const MeshFileContent &content, const std::string &extension,
                              const JobControl &control);

/// True if writeMesh knows the extension.
bool isMeshExtension(const std::filesystem::path &path);

} // namespace ductus
