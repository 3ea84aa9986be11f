#include "painting/storage/shape_blocks.h"

#include "base/sha256.h"
#include "painting/storage/array_slots.h"
#include "painting/storage/painting_json.h"
#include "painting/storage/painting_names.h"

namespace ductus {

namespace {

constexpr std::size_t blockPoints = 16'000; // their columns fit one buffer of BufferPacker

using Vec3f = Eigen::Vector3f;

// Names a block by what is in it: what is unknown of it stays while the points are the same.
template <typename T>
std::string blockPlace(const std::vector<T> &values)
{
    return "block@" + sha256Hex(std::as_bytes(std::span(values)));
}

void append(std::vector<float> &column, const Vec3f &v)
{
    column.insert(column.end(), v.data(), v.data() + 3);
}

Vec3f tripleAt(const std::vector<float> &column, std::size_t row)
{
    return {column[3 * row], column[3 * row + 1], column[3 * row + 2]};
}

struct PointColumns
{
    std::vector<float> positions, normals, halfWidths, colours, opacities;

    void add(const PaintedPoint &point)
    {
        append(positions, point.position);
        append(normals, point.normal);
        halfWidths.push_back(point.halfWidth);
        append(colours, point.colour);
        opacities.push_back(point.opacity);
    }

    PaintedPoint at(std::size_t row) const
    {
        return {tripleAt(positions, row), tripleAt(normals, row), halfWidths[row], tripleAt(colours, row),
                opacities[row]};
    }
};

} // namespace

void ShapeBlockWriter::add(const Drawing &drawing)
{
    std::vector<const StrokeShape *> strokes;
    std::size_t points = 0;
    const auto flush = [&] {
        if (!strokes.empty())
            addStrokes(strokes);
        strokes.clear();
        points = 0;
    };
    for (const Element &element : drawing.elements) {
        if (!mNumbers.emplace(element.shape.get(), int(mNumbers.size())).second)
            continue;
        if (const auto *stroke = std::get_if<StrokeShape>(element.shape.get())) {
            strokes.push_back(stroke);
            points += stroke->points.size();
            if (points >= blockPoints)
                flush();
        } else {
            flush();
            addMesh(std::get<MeshShape>(*element.shape));
        }
    }
    flush();
}

void ShapeBlockWriter::addStrokes(const std::vector<const StrokeShape *> &strokes)
{
    std::vector<std::uint8_t> sections;
    std::vector<std::uint32_t> counts;
    PointColumns columns;
    for (const StrokeShape *stroke : strokes) {
        const auto section = std::ranges::find(storedSections, stroke->section);
        sections.push_back(std::uint8_t(section - storedSections.begin()));
        counts.push_back(std::uint32_t(stroke->points.size()));
        for (const PaintedPoint &point : stroke->points)
            columns.add(point);
    }
    mPacker.startBuffer();
    OrderedJson block = {{"kind", wordOf(blockKindNames, BlockKind::Strokes)},
                         {"sections", addArray(mPacker, sections)},
                         {"pointCounts", addArray(mPacker, counts)},
                         {"positions", addArray(mPacker, columns.positions, 3, "element")},
                         {"normals", addArray(mPacker, columns.normals, 3)},
                         {"halfWidths", addArray(mPacker, columns.halfWidths, 1, "element")},
                         {"colours", addArray(mPacker, columns.colours, 3, "linear RGB")},
                         {"opacities", addArray(mPacker, columns.opacities)}};
    mPacker.startBuffer();
    if (const auto found = mUnknown.find(blockPlace(columns.positions)); found != mUnknown.end())
        addUnknown(block, found->second);
    mBlocks.push_back(std::move(block));
}

void ShapeBlockWriter::addMesh(const MeshShape &shape)
{
    std::vector<double> vertices;
    for (const Vec3 &vertex : shape.mesh.vertices)
        vertices.insert(vertices.end(), vertex.data(), vertex.data() + 3);
    std::vector<std::int32_t> corners;
    for (const Triangle &triangle : shape.mesh.triangles)
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    std::vector<float> colours;
    for (const Vec3f &colour : shape.vertexColours)
        append(colours, colour);
    mPacker.startBuffer();
    OrderedJson block = {{"kind", wordOf(blockKindNames, BlockKind::Mesh)},
                         {"vertices", addArray(mPacker, vertices, 3, "element")},
                         {"triangles", addArray(mPacker, corners, 3)},
                         {"colours", addArray(mPacker, colours, 3, "linear RGB")}};
    mPacker.startBuffer();
    const std::string place = blockPlace(vertices);
    if (shape.link) {
        block["link"] = linkJson(*shape.link);
        if (const auto found = mUnknown.find(place + "/link"); found != mUnknown.end())
            addUnknown(block["link"], found->second);
    }
    if (const auto found = mUnknown.find(place); found != mUnknown.end())
        addUnknown(block, found->second);
    mBlocks.push_back(std::move(block));
}

namespace {

using Shapes = std::vector<std::shared_ptr<const ElementShape>>;

void keepUnknown(const JsonReader &block, const std::string &place,
                 std::initializer_list<std::string_view> known, UnknownPaintingMembers &unknown)
{
    if (UnknownMembers members = block.unknown(known); !members.empty())
        unknown.emplace(place, std::move(members));
}

void readStrokes(const JsonReader &block, ArrayLoader &arrays, UnknownPaintingMembers &unknown,
                 Shapes &shapes)
{
    const auto sections = arrays.load<std::uint8_t>(block, "sections", 1);
    const auto counts = arrays.load<std::uint32_t>(block, "pointCounts", 1);
    PointColumns columns;
    columns.positions = arrays.load<float>(block, "positions", 3);
    columns.normals = arrays.load<float>(block, "normals", 3);
    columns.halfWidths = arrays.load<float>(block, "halfWidths", 1);
    columns.colours = arrays.load<float>(block, "colours", 3);
    columns.opacities = arrays.load<float>(block, "opacities", 1);
    const std::size_t points = columns.halfWidths.size();
    if (counts.size() != sections.size())
        block.failAt("pointCounts", "there must be one count a stroke");
    if (columns.positions.size() != 3 * points || columns.normals.size() != 3 * points ||
        columns.colours.size() != 3 * points || columns.opacities.size() != points)
        block.failAt("positions", "the columns of the points are not equally long");
    if (block.failed())
        return;
    std::size_t row = 0;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        if (sections[i] >= storedSections.size())
            return block.failAt("sections", "there is no section " + std::to_string(sections[i]));
        if (counts[i] == 0 || counts[i] > points - row)
            return block.failAt("pointCounts", "the strokes do not fit their points");
        StrokeShape stroke;
        stroke.section = storedSections[sections[i]];
        stroke.points.reserve(counts[i]);
        for (std::uint32_t k = 0; k < counts[i]; ++k)
            stroke.points.push_back(columns.at(row++));
        shapes.push_back(std::make_shared<const ElementShape>(std::move(stroke)));
    }
    if (row != points)
        block.failAt("pointCounts", "the strokes do not fit their points");
    keepUnknown(
        block, blockPlace(columns.positions),
        {"kind", "sections", "pointCounts", "positions", "normals", "halfWidths", "colours", "opacities"},
        unknown);
}

void readMesh(const JsonReader &block, ArrayLoader &arrays, UnknownPaintingMembers &unknown, Shapes &shapes)
{
    const auto vertices = arrays.load<double>(block, "vertices", 3);
    const auto corners = arrays.load<std::int32_t>(block, "triangles", 3);
    const auto colours = arrays.load<float>(block, "colours", 3);
    if (vertices.size() / 3 > std::size_t(INT32_MAX))
        block.failAt("vertices", "there are too many vertices", ErrorCode::TooLarge);
    if (colours.size() != vertices.size())
        block.failAt("colours", "there must be one colour a vertex");
    if (block.failed())
        return;
    MeshShape shape;
    for (std::size_t i = 0; i < vertices.size() / 3; ++i) {
        shape.mesh.vertices.emplace_back(vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]);
        shape.vertexColours.push_back(tripleAt(colours, i));
    }
    for (std::size_t t = 0; t < corners.size() / 3; ++t)
        shape.mesh.triangles.push_back({corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]});
    const std::string place = blockPlace(vertices);
    if (block.has("link")) {
        const JsonReader link = block.member("link");
        shape.link = linkFromJson(link);
        keepUnknown(link, place + "/link", {"file", "document", "name", "sha256"}, unknown);
    }
    shapes.push_back(std::make_shared<const ElementShape>(std::move(shape)));
    keepUnknown(block, place, {"kind", "vertices", "triangles", "colours", "link"}, unknown);
}

} // namespace

std::vector<std::shared_ptr<const ElementShape>> readShapeBlocks(const JsonReader &reader,
                                                                 std::string_view key, ArrayLoader &arrays,
                                                                 UnknownPaintingMembers &unknown)
{
    Shapes shapes;
    for (const JsonReader &block : reader.elements(key, maxPaintingParts)) {
        if (block.failed())
            break;
        if (block.oneOf<BlockKind>("kind", blockKindNames) == BlockKind::Strokes)
            readStrokes(block, arrays, unknown, shapes);
        else
            readMesh(block, arrays, unknown, shapes);
    }
    return shapes;
}

} // namespace ductus
