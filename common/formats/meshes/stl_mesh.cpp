#include "formats/meshes/byte_reader.h"
#include "formats/meshes/mesh_builder.h"
#include "formats/meshes/mesh_formats.h"
#include "formats/text/number_text.h"
#include "formats/text/text_lines.h"

namespace ductus {

namespace {

constexpr std::size_t headerSize = 80;
constexpr std::size_t triangleSize = 50; // normal, three corners, attribute

std::string lowerCase(std::string_view word)
{
    std::string lower(word.substr(0, 16));
    for (char &c : lower)
        if (c >= 'A' && c <= 'Z')
            c = char(c - 'A' + 'a');
    return lower;
}

} // namespace

bool isBinaryStl(std::string_view bytes)
{
    ByteReader reader(bytes);
    std::uint32_t count = 0;
    return reader.skip(headerSize) && reader.read(count) &&
           std::uint64_t(bytes.size()) == headerSize + 4 + std::uint64_t(count) * triangleSize;
}

Result<TriangleMesh> readAsciiStlMesh(std::string_view bytes, const std::string &name,
                                      const JobControl &control)
{
    TextLines lines(bytes, name, readingTheMesh);
    MeshBuilder builder;
    std::vector<std::int64_t> corners;
    bool inFacet = false;
    std::string_view line;
    while (lines.next(line)) {
        if (const auto stop = lines.tick(control))
            return *stop;
        Words words(line);
        const std::string keyword = lowerCase(words.next());
        if (keyword == "vertex") {
            if (!inFacet)
                return lines.error(ErrorCode::Malformed, "there is a vertex outside of a facet",
                                   "Export the mesh again");
            Vec3 position;
            if (const auto error = lines.readPoint(words, position, "the vertex"))
                return *error;
            corners.push_back(builder.vertexCount());
            if (const auto fault = builder.addVertex(position))
                return fault->at(lines.place());
        } else if (keyword == "facet") {
            if (inFacet)
                return lines.error(ErrorCode::Malformed, "a facet begins before the last one has ended",
                                   "Export the mesh again");
            inFacet = true;
            corners.clear();
        } else if (keyword == "endfacet") {
            if (!inFacet || corners.size() < 3)
                return lines.error(ErrorCode::Malformed,
                                   "the facet has " + std::to_string(corners.size()) +
                                       " corners instead of 3",
                                   "Export the mesh again");
            if (const auto fault = builder.addPolygon(corners))
                return fault->at(lines.place());
            inFacet = false;
        } else if (!keyword.empty() && keyword != "solid" && keyword != "endsolid" && keyword != "outer" &&
                   keyword != "endloop") {
            return lines.error(ErrorCode::Malformed, inQuotes(keyword) + " is no word of an STL file",
                               "Correct this line or export the mesh again");
        }
    }
    if (lines.failure())
        return *lines.failure();
    if (inFacet)
        return lines.error(ErrorCode::Malformed, "the file ends inside a facet",
                           "The file seems cut off: copy or export it again");
    builder.mergeEqualVertices();
    return builder.finish(name);
}

Result<TriangleMesh> readBinaryStlMesh(std::string_view bytes, const std::string &name,
                                       const JobControl &control)
{
    const auto malformed = [&](const std::string &problem, const std::string &remedy) {
        return Error{ErrorCode::Malformed, readingTheMesh, problem, remedy, name};
    };
    ByteReader reader(bytes);
    std::uint32_t count = 0;
    if (!reader.skip(headerSize) || !reader.read(count))
        return malformed("the file is shorter than the header of an STL file",
                         "The file seems cut off: copy or export it again");
    if (reader.remaining() / triangleSize < count)
        return malformed("the file announces " + std::to_string(count) + " triangles but has room for " +
                             std::to_string(reader.remaining() / triangleSize),
                         "The file seems cut off: copy or export it again");
    MeshBuilder builder;
    for (std::uint32_t t = 0; t < count; ++t) {
        if (cancelledAt(control, t))
            return cancelledError(readingTheMesh);
        const std::string place = name + ": byte " + std::to_string(reader.offset());
        reader.skip(3 * sizeof(float)); // the normal follows from the corners
        std::int64_t corners[3];
        for (std::int64_t &corner : corners) {
            float position[3] = {};
            for (float &x : position)
                reader.read(x);
            corner = builder.vertexCount();
            if (const auto fault = builder.addVertex(Vec3(position[0], position[1], position[2])))
                return fault->at(place);
        }
        reader.skip(sizeof(std::uint16_t));
        if (const auto fault = builder.addPolygon(corners))
            return fault->at(place);
    }
    builder.mergeEqualVertices();
    return builder.finish(name);
}

Result<std::string> writeStlMesh(const MeshFileContent &content, const JobControl &control)
{
    const TriangleMesh &mesh = content.mesh;
    std::string bytes;
    bytes.reserve(headerSize + 4 + mesh.triangles.size() * triangleSize);
    // A header that began with "solid" would make many programs take the file for text.
    bytes = "binary STL. " + commentLine(content, headerSize - 12);
    bytes.resize(headerSize, ' ');
    appendLittleEndian(bytes, std::uint32_t(mesh.triangles.size()));
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (cancelledAt(control, std::size_t(t)))
            return cancelledError("Writing the mesh");
        const Vec3 area = mesh.areaVector(t);
        const double length = area.norm();
        const Vec3 normal = length > 0.0 ? Vec3(area / length) : Vec3(Vec3::Zero());
        for (int k = 0; k < 3; ++k)
            appendLittleEndian(bytes, float(normal[k]));
        for (const int v : mesh.triangles[std::size_t(t)])
            for (int k = 0; k < 3; ++k)
                appendLittleEndian(bytes, float(mesh.vertices[std::size_t(v)][k]));
        appendLittleEndian(bytes, std::uint16_t(0));
    }
    return bytes;
}

} // namespace ductus
