#include "formats/mesh_file.h"

#include "formats/atomic_file.h"
#include "formats/meshes/mesh_builder.h"
#include "formats/meshes/mesh_formats.h"
#include "formats/text/number_text.h"
#include "formats/text/text_lines.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace ductus {

namespace {

constexpr std::size_t largestMeshFile = std::size_t(2) << 30;

using MeshWriter = Result<std::string> (*)(const MeshFileContent &, const JobControl &);

std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return text;
}

MeshWriter writerFor(const std::string &extension)
{
    static constexpr std::pair<std::string_view, MeshWriter> writers[] = {
        {".obj", writeObjMesh}, {".ply", writePlyMesh}, {".stl", writeStlMesh},
        {".off", writeOffMesh}, {".glb", writeGlbMesh},
    };
    const std::string wanted = lowerCase(extension);
    for (const auto &[known, writer] : writers)
        if (wanted == known)
            return writer;
    return nullptr;
}

Result<TriangleMesh> parseAnyMesh(std::string_view bytes, const std::string &name, const JobControl &control)
{
    if (bytes.empty())
        return Error{ErrorCode::TooLittleData, readingTheMesh, "the file is empty", "Export the mesh again",
                     name};
    std::string_view text = bytes;
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    const std::string_view firstWord =
        Words(text.substr(0, std::min(text.find_first_of("\r\n"), text.size()))).next();
    if (bytes.starts_with("glTF"))
        return readGlbMesh(bytes, name, control);
    if (firstWord == "ply")
        return readPlyMesh(text, name, control);
    // Some binary STL files begin with "solid" too: their size gives them away.
    if (isBinaryStl(bytes))
        return readBinaryStlMesh(bytes, name, control);
    if (firstWord == "solid")
        return readAsciiStlMesh(bytes, name, control);
    if (isOffHeader(firstWord))
        return readOffMesh(bytes, name, control);
    if (firstWord.starts_with("{"))
        return Error{ErrorCode::Unsupported, readingTheMesh,
                     "this is JSON, perhaps a glTF scene in text form", "Export it as binary glTF (.glb)",
                     name};
    if (lowerCase(std::filesystem::path(name).extension().string()) == ".stl")
        return readBinaryStlMesh(bytes, name, control);
    return readObjMesh(bytes, name, control);
}

std::optional<Error> checkContent(const MeshFileContent &content)
{
    const auto invalid = [](const std::string &problem) {
        return Error{ErrorCode::InvalidArgument, "Writing the mesh", problem, "", ""};
    };
    const TriangleMesh &mesh = content.mesh;
    const auto inRange = [&](int v) { return v >= 0 && v < mesh.vertexCount(); };
    for (const Vec3 &v : mesh.vertices)
        if (!(v.cwiseAbs().maxCoeff() <= largestCoordinate) || !v.allFinite())
            return invalid("a vertex is not finite");
    for (const Triangle &t : mesh.triangles)
        if (!std::all_of(t.begin(), t.end(), inRange))
            return invalid("a triangle uses a vertex that does not exist");
    for (const auto &polyline : content.featureLines)
        if (polyline.size() < 2 || !std::all_of(polyline.begin(), polyline.end(), inRange))
            return invalid("a feature line is too short or uses a vertex that does not exist");
    if (!content.triangleRegions.empty() && content.triangleRegions.size() != mesh.triangles.size())
        return invalid("there are " + std::to_string(content.triangleRegions.size()) +
                       " region numbers for " + std::to_string(mesh.triangles.size()) + " triangles");
    if (std::any_of(content.triangleRegions.begin(), content.triangleRegions.end(),
                    [](int r) { return r < 0; }))
        return invalid("a region number is negative");
    if (!content.vertexColours.empty() && content.vertexColours.size() != mesh.vertices.size())
        return invalid("there are " + std::to_string(content.vertexColours.size()) + " colours for " +
                       std::to_string(mesh.vertices.size()) + " vertices");
    for (const Eigen::Vector4f &colour : content.vertexColours)
        if (!(colour.minCoeff() >= 0.f && colour.maxCoeff() <= 1.f))
            return invalid("a colour is outside 0..1");
    if (!content.regionNames.empty() &&
        std::any_of(content.triangleRegions.begin(), content.triangleRegions.end(),
                    [&](int r) { return std::size_t(r) >= content.regionNames.size(); }))
        return invalid("a region has no name");
    if (mesh.isEmpty())
        return Error{ErrorCode::TooLittleData, "Writing the mesh", "there are no triangles", "", ""};
    return std::nullopt;
}

} // namespace

std::vector<int> regionsOf(const MeshFileContent &content)
{
    if (content.triangleRegions.empty())
        return {0};
    std::vector<int> regions = content.triangleRegions;
    std::sort(regions.begin(), regions.end());
    regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
    return regions;
}

int regionOf(const MeshFileContent &content, int t)
{
    return content.triangleRegions.empty() ? 0 : content.triangleRegions[std::size_t(t)];
}

std::string commentLine(const MeshFileContent &content, std::size_t longest)
{
    std::string line = content.comment.empty() ? std::string("Ductus") : content.comment.substr(0, longest);
    for (char &c : line)
        if (c < ' ' || c > '~')
            c = ' ';
    return line;
}

Result<TriangleMesh> parseMesh(std::string_view bytes, const std::string &name, const JobControl &control)
{
    try {
        return parseAnyMesh(bytes, name, control);
    } catch (const std::bad_alloc &) {
        return Error{ErrorCode::TooLarge, readingTheMesh, "the memory does not suffice for it",
                     "Simplify the mesh first", name};
    }
}

Result<TriangleMesh> readMesh(const std::filesystem::path &path, const JobControl &control)
{
    const Result<std::string> bytes = readWholeFile(path, largestMeshFile, readingTheMesh);
    if (!bytes)
        return bytes.error();
    return parseMesh(*bytes, path.filename().string(), control);
}

Result<ColouredMesh> readColouredMesh(const std::filesystem::path &path, const JobControl &control)
{
    const Result<std::string> bytes = readWholeFile(path, largestMeshFile, readingTheMesh);
    if (!bytes)
        return bytes.error();
    const std::string name = path.filename().string();
    if (!bytes->starts_with("glTF")) {
        Result<TriangleMesh> mesh = parseMesh(*bytes, name, control);
        if (!mesh)
            return mesh.error();
        return ColouredMesh{std::move(*mesh), {}};
    }
    try {
        return readColouredGlbMesh(*bytes, name, control);
    } catch (const std::bad_alloc &) {
        return Error{ErrorCode::TooLarge, readingTheMesh, "the memory does not suffice for it",
                     "Simplify the mesh first", name};
    }
}

Result<std::string> meshBytes(const MeshFileContent &content, const std::string &extension,
                              const JobControl &control)
{
    const MeshWriter writer = writerFor(extension);
    if (!writer)
        return Error{ErrorCode::InvalidArgument, "Writing the mesh",
                     "no mesh format has the extension " + inQuotes(extension),
                     "Give a name that ends in .obj, .ply, .stl, .off or .glb", ""};
    if (auto error = checkContent(content))
        return *error;
    if (control.isCancelled())
        return cancelledError("Writing the mesh");
    return writer(content, control);
}

Result<void> writeMesh(const MeshFileContent &content, const std::filesystem::path &path,
                       const JobControl &control)
{
    try {
        Result<std::string> bytes = meshBytes(content, path.extension().string(), control);
        if (!bytes) {
            Error error = bytes.error();
            error.place = path.string();
            return error;
        }
        if (control.isCancelled())
            return cancelledError("Writing the mesh");
        return writeFileAtomically(path, std::as_bytes(std::span(*bytes)), "Writing the mesh");
    } catch (const std::bad_alloc &) {
        return Error{ErrorCode::TooLarge, "Writing the mesh", "the memory does not suffice",
                     "Simplify the mesh first", path.string()};
    }
}

bool isMeshExtension(const std::filesystem::path &path)
{
    return writerFor(path.extension().string()) != nullptr;
}

} // namespace ductus
