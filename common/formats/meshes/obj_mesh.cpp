#include "formats/meshes/mesh_builder.h"
#include "formats/meshes/mesh_formats.h"
#include "formats/text/number_text.h"
#include "formats/text/obj_index.h"

namespace ductus {

Result<TriangleMesh> readObjMesh(std::string_view bytes, const std::string &name, const JobControl &control)
{
    TextLines lines(bytes, name, readingTheMesh);
    MeshBuilder builder;
    std::vector<std::int64_t> corners;
    std::int64_t polylines = 0;
    std::int64_t faces = 0;
    std::string_view line;
    while (lines.next(line, true)) {
        if (const auto stop = lines.tick(control))
            return *stop;
        Words words(line);
        const std::string_view keyword = words.next();
        std::optional<MeshBuilder::Fault> fault;
        if (keyword == "v") {
            Vec3 vertex;
            if (const auto error = lines.readPoint(words, vertex, "the vertex"))
                return *error;
            fault = builder.addVertex(vertex);
        } else if (keyword == "f") {
            ++faces;
            corners.clear();
            for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
                const Result<int> index = readObjIndex(word, builder.vertexCount(), lines);
                if (!index)
                    return index.error();
                corners.push_back(*index);
            }
            fault = builder.addPolygon(corners);
        } else if (keyword == "l") {
            ++polylines;
        }
        if (fault)
            return fault->at(lines.place());
    }
    if (lines.failure())
        return *lines.failure();
    if (faces == 0 && polylines > 0)
        return lines.fileError(ErrorCode::Unsupported, "this is a sketch: it has lines and no faces",
                               "Give it as the sketch, and a mesh with faces here");
    if (faces == 0 && builder.vertexCount() == 0)
        return lines.fileError(ErrorCode::Unsupported, "this is no mesh file that is known",
                               "Give a mesh as OBJ, PLY, STL, OFF or GLB");
    return builder.finish(name);
}

Result<std::string> writeObjMesh(const MeshFileContent &content, const JobControl &control)
{
    std::string text = "# " + commentLine(content) + "\n";
    for (std::size_t v = 0; v < content.mesh.vertices.size(); ++v) {
        if (cancelledAt(control, v))
            return cancelledError("Writing the mesh");
        text += 'v';
        for (int k = 0; k < 3; ++k) {
            text += ' ';
            appendNumber(text, content.mesh.vertices[v][k]);
        }
        text += '\n';
    }
    const auto appendIndex = [&](int index) {
        text += ' ';
        appendNumber(text, std::int64_t(index) + 1);
    };
    // One pass over the triangles however many regions there are.
    const std::vector<int> regions = regionsOf(content);
    std::vector<std::vector<int>> trianglesOf(regions.size());
    for (int t = 0; t < content.mesh.triangleCount(); ++t) {
        const auto place = std::lower_bound(regions.begin(), regions.end(), regionOf(content, t));
        trianglesOf[std::size_t(place - regions.begin())].push_back(t);
    }
    for (std::size_t r = 0; r < regions.size(); ++r) {
        if (!content.triangleRegions.empty())
            text += "g region_" + std::to_string(regions[r]) + "\n";
        for (const int t : trianglesOf[r]) {
            if (cancelledAt(control, std::size_t(t)))
                return cancelledError("Writing the mesh");
            text += 'f';
            for (const int v : content.mesh.triangles[std::size_t(t)])
                appendIndex(v);
            text += '\n';
        }
    }
    if (!content.featureLines.empty())
        text += "g features\n";
    for (const auto &polyline : content.featureLines) {
        text += 'l';
        for (const int v : polyline)
            appendIndex(v);
        text += '\n';
    }
    return text;
}

} // namespace ductus
