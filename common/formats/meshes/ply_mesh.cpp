#include "formats/meshes/byte_reader.h"
#include "formats/meshes/mesh_builder.h"
#include "formats/meshes/mesh_formats.h"
#include "formats/meshes/ply_header.h"
#include "formats/text/number_text.h"

#include <cmath>

namespace ductus {

namespace {

/// Where the numbers of a PLY body come from: lines or bytes.
class PlyBody
{
public:
    virtual ~PlyBody() = default;
    /// Called before each item of an element.
    virtual std::optional<Error> beginItem() = 0;
    virtual std::optional<Error> read(PlyType type, double &value) = 0;
    /// No more values than this can follow, whatever a count says.
    virtual std::size_t mostValues(PlyType type) const = 0;
    /// No more items of \a element, which has properties, than this can follow.
    virtual std::size_t mostItems(const PlyElement &element) const = 0;
    virtual Error error(const std::string &problem, const std::string &remedy) const = 0;
};

class AsciiPlyBody : public PlyBody
{
public:
    AsciiPlyBody(TextLines &lines, std::size_t fileSize) : mLines(lines), mFileSize(fileSize) {}

    std::optional<Error> beginItem() override
    {
        std::string_view line;
        while (mLines.next(line)) {
            mWords = Words(line);
            if (!Words(line).next().empty())
                return std::nullopt;
        }
        if (mLines.failure())
            return mLines.failure();
        return error("the file ends before all announced items",
                     "The file seems cut off: copy or export it again");
    }

    std::optional<Error> read(PlyType type, double &value) override
    {
        const std::string_view word = mWords.next();
        if (word.empty())
            return error("the line has too few numbers", "Correct this line or export the mesh again");
        const NumberFault fault = readNumber(word, value);
        if (fault != NumberFault::None)
            return error("the value " + describeFault(fault, word), remedyForFault(fault));
        return std::nullopt;
    }

    std::size_t mostValues(PlyType) const override { return mFileSize / 2; }
    std::size_t mostItems(const PlyElement &element) const override
    {
        return mFileSize / (2 * element.properties.size());
    }

    Error error(const std::string &problem, const std::string &remedy) const override
    {
        return mLines.error(ErrorCode::Malformed, problem, remedy);
    }

private:
    TextLines &mLines;
    std::size_t mFileSize;
    Words mWords{""};
};

class BinaryPlyBody : public PlyBody
{
public:
    BinaryPlyBody(std::string_view bytes, std::size_t bodyBegin, std::endian order, std::string name)
        : mReader(bytes.substr(bodyBegin), order), mBodyBegin(bodyBegin), mName(std::move(name))
    {
    }

    std::optional<Error> beginItem() override { return std::nullopt; }

    std::optional<Error> read(PlyType type, double &value) override
    {
        switch (type) {
        case PlyType::Int8:
            return readAs<std::int8_t>(value);
        case PlyType::UInt8:
            return readAs<std::uint8_t>(value);
        case PlyType::Int16:
            return readAs<std::int16_t>(value);
        case PlyType::UInt16:
            return readAs<std::uint16_t>(value);
        case PlyType::Int32:
            return readAs<std::int32_t>(value);
        case PlyType::UInt32:
            return readAs<std::uint32_t>(value);
        case PlyType::Float32:
            return readAs<float>(value);
        case PlyType::Float64:
            break;
        }
        return readAs<double>(value);
    }

    std::size_t mostValues(PlyType type) const override { return mReader.remaining() / plyTypeSize(type); }
    std::size_t mostItems(const PlyElement &element) const override
    {
        return mReader.remaining() / element.leastBytes();
    }

    Error error(const std::string &problem, const std::string &remedy) const override
    {
        return {ErrorCode::Malformed, readingTheMesh, problem, remedy,
                mName + ": byte " + std::to_string(mBodyBegin + mReader.offset())};
    }

private:
    template <typename T>
    std::optional<Error> readAs(double &value)
    {
        T raw = 0;
        if (!mReader.read(raw))
            return error("the file ends before all announced items",
                         "The file seems cut off: copy or export it again");
        value = double(raw);
        return std::nullopt;
    }

    ByteReader mReader;
    std::size_t mBodyBegin;
    std::string mName;
};

class PlyReader
{
public:
    PlyReader(PlyBody &body, const JobControl &control) : mBody(body), mControl(control) {}

    std::optional<Error> readElement(const PlyElement &element);
    Result<TriangleMesh> finish(const std::string &name) { return mBuilder.finish(name); }

private:
    std::optional<Error> readItem(const PlyElement &element);
    std::optional<Error> readList(const PlyProperty &property, bool wanted);

    PlyBody &mBody;
    const JobControl &mControl;
    MeshBuilder mBuilder;
    int mCoordinate[3] = {-1, -1, -1}; // which properties of the element under way
    int mCorners = -1;
    std::vector<std::int64_t> mList;
};

std::optional<Error> PlyReader::readList(const PlyProperty &property, bool wanted)
{
    double length = 0.0;
    if (auto error = mBody.read(property.countType, length))
        return error;
    if (length < 0.0 || length != std::floor(length) || length > double(mBody.mostValues(property.type)))
        return mBody.error("a list announces more values than the file can hold, or fewer than none",
                           "Repair the mesh or export it again");
    mList.clear();
    for (std::int64_t i = 0; i < std::int64_t(length); ++i) {
        double value = 0.0;
        if (auto error = mBody.read(property.type, value))
            return error;
        if (!wanted)
            continue;
        if (value != std::floor(value) || std::abs(value) > 9e15)
            return mBody.error("a vertex index is no whole number", "Repair the mesh or export it again");
        mList.push_back(std::int64_t(value));
    }
    return std::nullopt;
}

std::optional<Error> PlyReader::readItem(const PlyElement &element)
{
    if (auto error = mBody.beginItem())
        return error;
    Vec3 position = Vec3::Zero();
    for (int p = 0; p < int(element.properties.size()); ++p) {
        const PlyProperty &property = element.properties[std::size_t(p)];
        if (property.isList) {
            if (auto error = readList(property, p == mCorners))
                return error;
            if (p == mCorners)
                if (const auto fault = mBuilder.addPolygon(mList))
                    return Error{fault->code, readingTheMesh, fault->problem, fault->remedy,
                                 mBody.error("", "").place};
            continue;
        }
        double value = 0.0;
        if (auto error = mBody.read(property.type, value))
            return error;
        for (int k = 0; k < 3; ++k)
            if (mCoordinate[k] == p)
                position[k] = value;
    }
    if (mCoordinate[0] >= 0)
        if (const auto fault = mBuilder.addVertex(position))
            return Error{fault->code, readingTheMesh, fault->problem, fault->remedy,
                         mBody.error("", "").place};
    return std::nullopt;
}

std::optional<Error> PlyReader::readElement(const PlyElement &element)
{
    std::fill(mCoordinate, mCoordinate + 3, -1);
    mCorners = -1;
    if (element.name == "vertex") {
        for (int k = 0; k < 3; ++k) {
            mCoordinate[k] = element.indexOf(std::string_view("xyz").substr(std::size_t(k), 1));
            if (mCoordinate[k] < 0 || element.properties[std::size_t(mCoordinate[k])].isList)
                return mBody.error("the vertices have no x, y and z", "Export the mesh again");
        }
    } else if (element.name == "face") {
        mCorners = element.indexOf("vertex_indices");
        if (mCorners < 0)
            mCorners = element.indexOf("vertex_index");
        if (mCorners < 0 || !element.properties[std::size_t(mCorners)].isList)
            return mBody.error("the faces have no list vertex_indices", "Export the mesh again");
    } else if (element.name == "tristrips") {
        return mBody.error("the mesh is stored as triangle strips", "Export it with plain faces");
    }
    if (element.properties.empty())
        return std::nullopt;
    // Each item takes some bytes, so a count the file has no room for is refused before anything is read.
    if (std::uint64_t(element.count) > mBody.mostItems(element))
        return mBody.error("the header announces " + std::to_string(element.count) + " items of " +
                               inQuotes(element.name) + ", more than the file has room for",
                           "The file seems cut off: copy or export it again");
    for (std::int64_t i = 0; i < element.count; ++i) {
        if (i % 4096 == 0 && mControl.isCancelled())
            return cancelledError(readingTheMesh);
        if (auto error = readItem(element))
            return error;
    }
    return std::nullopt;
}

} // namespace

Result<TriangleMesh> readPlyMesh(std::string_view bytes, const std::string &name, const JobControl &control)
{
    TextLines lines(bytes, name, readingTheMesh);
    const Result<PlyHeader> header = readPlyHeader(lines);
    if (!header)
        return header.error();
    AsciiPlyBody ascii(lines, bytes.size());
    BinaryPlyBody binary(
        bytes, std::size_t(lines.bytesGivenOut()),
        header->format == PlyFormat::BinaryBigEndian ? std::endian::big : std::endian::little, name);
    PlyReader reader(header->format == PlyFormat::Ascii ? static_cast<PlyBody &>(ascii) : binary, control);
    for (const PlyElement &element : header->elements)
        if (const auto error = reader.readElement(element))
            return *error;
    return reader.finish(name);
}

Result<std::string> writePlyMesh(const MeshFileContent &content, const JobControl &control)
{
    const TriangleMesh &mesh = content.mesh;
    const bool hasRegions = !content.triangleRegions.empty();
    std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment " + commentLine(content) +
                        "\nelement vertex " + std::to_string(mesh.vertexCount()) +
                        "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                        std::to_string(mesh.triangleCount()) + "\nproperty list uchar int vertex_indices\n" +
                        (hasRegions ? "property int region\n" : "") + "end_header\n";
    bytes.reserve(bytes.size() + mesh.vertices.size() * 24 + mesh.triangles.size() * 17);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (cancelledAt(control, v))
            return cancelledError("Writing the mesh");
        for (int k = 0; k < 3; ++k)
            appendLittleEndian(bytes, mesh.vertices[v][k]);
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (cancelledAt(control, t))
            return cancelledError("Writing the mesh");
        appendLittleEndian(bytes, std::uint8_t(3));
        for (const int v : mesh.triangles[t])
            appendLittleEndian(bytes, std::int32_t(v));
        if (hasRegions)
            appendLittleEndian(bytes, std::int32_t(content.triangleRegions[t]));
    }
    return bytes;
}

} // namespace ductus
