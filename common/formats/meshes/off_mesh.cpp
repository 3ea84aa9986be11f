#include "formats/meshes/mesh_builder.h"
#include "formats/meshes/mesh_formats.h"
#include "formats/text/number_text.h"
#include "formats/text/text_lines.h"

namespace ductus {

namespace {

/// Lines of an OFF file without blanks and comments.
class OffLines
{
public:
    OffLines(TextLines &lines, const JobControl &control) : mLines(lines), mControl(control) {}

    /// The words of the next line that has any. The Error says what was expected there when the file ends.
    std::optional<Error> next(Words &words, const std::string &expected)
    {
        std::string_view line;
        while (mLines.next(line)) {
            if (const auto stop = mLines.tick(mControl))
                return stop;
            line = line.substr(0, line.find('#'));
            if (Words(line).next().empty())
                continue;
            words = Words(line);
            return std::nullopt;
        }
        if (mLines.failure())
            return mLines.failure();
        return mLines.error(ErrorCode::Malformed, "the file ends where " + expected + " should stand",
                            "The file seems cut off: copy or export it again");
    }

private:
    TextLines &mLines;
    const JobControl &mControl;
};

std::optional<Error> readCount(const TextLines &lines, Words &words, const char *what, std::int64_t &count)
{
    const std::string_view word = words.next();
    const NumberFault fault = readInteger(word, count);
    if (fault != NumberFault::None || count < 0)
        return lines.error(ErrorCode::Malformed,
                           std::string("the number of ") + what + " is " + inQuotes(word),
                           "Correct the counts after the OFF header or export the mesh again");
    return std::nullopt;
}

} // namespace

bool isOffHeader(std::string_view word)
{
    for (const std::string_view prefix : {"ST", "C", "N"})
        if (word.starts_with(prefix) && word.size() > 3)
            word.remove_prefix(prefix.size());
    return word == "OFF";
}

Result<TriangleMesh> readOffMesh(std::string_view bytes, const std::string &name, const JobControl &control)
{
    TextLines lines(bytes, name, readingTheMesh);
    OffLines offLines(lines, control);
    Words words("");
    if (const auto error = offLines.next(words, "the OFF header"))
        return *error;
    words.next();
    // The counts may stand on the header's line.
    Words rest = words;
    if (rest.next().empty())
        if (const auto error = offLines.next(words, "the counts"))
            return *error;
    std::int64_t vertexCount = 0;
    std::int64_t faceCount = 0;
    if (const auto error = readCount(lines, words, "vertices", vertexCount))
        return *error;
    if (const auto error = readCount(lines, words, "faces", faceCount))
        return *error;
    // A vertex or a face takes 6 bytes at least ("0 0 0\n"): counts beyond the file's size are refused at
    // once.
    if (vertexCount > std::int64_t(bytes.size()) / 6 || faceCount > std::int64_t(bytes.size()) / 6)
        return lines.error(ErrorCode::Malformed, "the counts are more than the file can hold",
                           "The file seems cut off: copy or export it again");

    MeshBuilder builder;
    for (std::int64_t v = 0; v < vertexCount; ++v) {
        if (const auto error = offLines.next(words, "vertex " + std::to_string(v)))
            return *error;
        Vec3 position;
        if (const auto error = lines.readPoint(words, position, "the vertex"))
            return *error;
        if (const auto fault = builder.addVertex(position))
            return fault->at(lines.place());
    }
    std::vector<std::int64_t> corners;
    for (std::int64_t f = 0; f < faceCount; ++f) {
        if (const auto error = offLines.next(words, "face " + std::to_string(f)))
            return *error;
        std::int64_t cornerCount = 0;
        if (const auto error = readCount(lines, words, "corners", cornerCount))
            return *error;
        corners.clear();
        for (std::int64_t c = 0; c < cornerCount; ++c) {
            const std::string_view word = words.next();
            std::int64_t corner = 0;
            const NumberFault fault = readInteger(word, corner);
            if (word.empty())
                return lines.error(ErrorCode::Malformed,
                                   "the face announces " + std::to_string(cornerCount) + " corners but has " +
                                       std::to_string(c),
                                   "Correct this line or export the mesh again");
            if (fault != NumberFault::None)
                return lines.error(ErrorCode::Malformed, "the vertex index " + describeFault(fault, word),
                                   "Correct this line or export the mesh again");
            corners.push_back(corner);
        }
        if (const auto fault = builder.addPolygon(corners))
            return fault->at(lines.place());
    }
    return builder.finish(name);
}

Result<std::string> writeOffMesh(const MeshFileContent &content, const JobControl &control)
{
    const TriangleMesh &mesh = content.mesh;
    std::string text = "OFF\n# " + commentLine(content) + "\n" + std::to_string(mesh.vertexCount()) + " " +
                       std::to_string(mesh.triangleCount()) + " 0\n";
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (cancelledAt(control, v))
            return cancelledError("Writing the mesh");
        for (int k = 0; k < 3; ++k) {
            if (k > 0)
                text += ' ';
            appendNumber(text, mesh.vertices[v][k]);
        }
        text += '\n';
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (cancelledAt(control, t))
            return cancelledError("Writing the mesh");
        text += '3';
        for (const int v : mesh.triangles[t]) {
            text += ' ';
            appendNumber(text, std::int64_t(v));
        }
        text += '\n';
    }
    return text;
}

} // namespace ductus
