// One pair of functions a mesh format. Readers get the whole file in memory; writers give its bytes. Content
// handed to a writer has been checked by meshBytes (indices in range, numbers finite, at least one triangle).
#pragma once

#include "formats/mesh_file.h"

namespace ductus {

Result<TriangleMesh> readObjMesh(std::string_view bytes, const std::string &name, const JobControl &control);
Result<std::string> writeObjMesh(const MeshFileContent &content, const JobControl &control);

/// ascii and binary of both byte orders.
Result<TriangleMesh> readPlyMesh(std::string_view bytes, const std::string &name, const JobControl &control);
/// Binary little-endian, double coordinates.
Result<std::string> writePlyMesh(const MeshFileContent &content, const JobControl &control);

Result<TriangleMesh> readAsciiStlMesh(std::string_view bytes, const std::string &name,
                                      const JobControl &control);
Result<TriangleMesh> readBinaryStlMesh(std::string_view bytes, const std::string &name,
                                       const JobControl &control);
/// True if the size is exactly what the triangle count says, whatever the first word.
bool isBinaryStl(std::string_view bytes);
Result<std::string> writeStlMesh(const MeshFileContent &content, const JobControl &control);

/// OFF with the optional prefixes for texture, colour, normals (STCNOFF); not 4OFF, nOFF or binary.
Result<TriangleMesh> readOffMesh(std::string_view bytes, const std::string &name, const JobControl &control);
Result<std::string> writeOffMesh(const MeshFileContent &content, const JobControl &control);
/// True if \a word is a header of the OFF family.
bool isOffHeader(std::string_view word);

/// Binary glTF 2.0: the triangles of all meshes of the scene, placed by their nodes.
Result<TriangleMesh> readGlbMesh(std::string_view bytes, const std::string &name, const JobControl &control);
/// With COLOR_0 and base colours of materials, multiplied; no colours if the scene has neither.
Result<ColouredMesh> readColouredGlbMesh(std::string_view bytes, const std::string &name,
                                         const JobControl &control);
Result<std::string> writeGlbMesh(const MeshFileContent &content, const JobControl &control);

/// Distinct numbers of content.triangleRegions in rising order, {0} if there are none.
std::vector<int> regionsOf(const MeshFileContent &content);
/// Region of triangle \a t; 0 if there are none.
int regionOf(const MeshFileContent &content, int t);
/// content.comment as one line of printable ASCII, "Ductus" if empty, at most \a longest characters.
std::string commentLine(const MeshFileContent &content, std::size_t longest = 200);

/// Cancel check for writers, asked every 4096 items.
inline bool cancelledAt(const JobControl &control, std::size_t item)
{
    return item % 4096 == 0 && control.isCancelled();
}

} // namespace ductus
