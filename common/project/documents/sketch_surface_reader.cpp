// sketchSurfaceFromJson(): every field checked, nothing believed.
#include "project/documents/sketch_surface_json.h"

#include "project/documents/sketch_surface_names.h"

#include <limits>
#include <set>

namespace ductus {

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallestPositive = std::numeric_limits<double>::denorm_min();

std::vector<Vec3> loadPoints(const JsonReader &reader, std::string_view key, ArrayLoader &arrays)
{
    const std::vector<double> flat = arrays.load<double>(reader, key, 3);
    std::vector<Vec3> points(flat.size() / 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = Vec3(flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]);
    return points;
}

// Indices of vertices, all below \a count.
std::vector<int> loadIndices(const JsonReader &reader, std::string_view key, std::uint64_t columns, int count,
                             ArrayLoader &arrays)
{
    std::vector<int> indices = arrays.load<std::int32_t>(reader, key, columns);
    for (int index : indices) {
        if (index < 0 || index >= count) {
            reader.failAt(key, "the number " + std::to_string(index) + " is out of range");
            return {};
        }
    }
    return indices;
}

TriangleMesh loadMesh(const JsonReader &reader, ArrayLoader &arrays)
{
    TriangleMesh mesh;
    mesh.vertices = loadPoints(reader, "vertices", arrays);
    if (mesh.vertices.size() > std::size_t(std::numeric_limits<int>::max()))
        reader.failAt("vertices", "there are too many vertices", ErrorCode::TooLarge);
    const std::vector<int> corners = loadIndices(reader, "triangles", 3, mesh.vertexCount(), arrays);
    mesh.triangles.resize(corners.size() / 3);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        mesh.triangles[t] = {corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]};
    return mesh;
}

std::vector<double> loadChannel(const JsonReader &reader, std::string_view key, std::size_t pointCount,
                                ArrayLoader &arrays)
{
    if (!reader.has(key))
        return {};
    std::vector<double> values = arrays.load<double>(reader, key, 1);
    if (!reader.failed() && values.size() != pointCount)
        reader.failAt(key, "there must be one value a point");
    return values;
}

Stroke loadStroke(const JsonReader &reader, ArrayLoader &arrays)
{
    Stroke stroke;
    stroke.id.value = std::int32_t(reader.integer("id", 0, std::numeric_limits<std::int32_t>::max()));
    stroke.role = reader.oneOf<StrokeRole>("role", strokeRoleNames);
    stroke.points = loadPoints(reader, "points", arrays);
    stroke.pressure = loadChannel(reader, "pressure", stroke.points.size(), arrays);
    stroke.timeSeconds = loadChannel(reader, "timeSeconds", stroke.points.size(), arrays);
    return stroke;
}

Vec3 loadTriple(const JsonReader &reader, std::string_view key)
{
    const std::array<double, 3> values = reader.triple(key);
    return {values[0], values[1], values[2]};
}

SurfacingSettings loadSettings(const JsonReader &reader)
{
    SurfacingSettings settings;
    settings.epsilon = reader.number("epsilon", smallestPositive, largest);
    settings.simplicity = reader.number("simplicity", 0.0, largest);
    settings.smoothness = reader.number("smoothness", 0.0, largest);
    settings.runs = int(reader.integer("runs", 1, 1000));
    settings.seed = reader.unsignedInteger("seed");
    if (reader.has("symmetryPlane")) {
        const JsonReader plane = reader.member("symmetryPlane");
        settings.symmetryPlane = StoredSymmetryPlane{loadTriple(plane, "point"), loadTriple(plane, "normal"),
                                                     plane.unknown({"point", "normal"})};
        if (settings.symmetryPlane->normal.isZero(0.0))
            plane.failAt("normal", "it has no length");
    }
    settings.unknown =
        reader.unknown({"epsilon", "simplicity", "smoothness", "runs", "seed", "symmetryPlane"});
    return settings;
}

std::vector<std::vector<int>> loadFeatureLines(const JsonReader &reader, int vertexCount, ArrayLoader &arrays)
{
    const std::vector<int> lengths = arrays.load<std::int32_t>(reader, "lengths", 1);
    const std::vector<int> vertices = loadIndices(reader, "vertices", 1, vertexCount, arrays);
    std::vector<std::vector<int>> lines;
    std::size_t begin = 0;
    for (int length : lengths) {
        if (length < 0 || std::size_t(length) > vertices.size() - begin) {
            reader.failAt("lengths", "the lines do not fit their vertices");
            return {};
        }
        const auto first = vertices.begin() + std::ptrdiff_t(begin);
        lines.emplace_back(first, first + length);
        begin += std::size_t(length);
    }
    if (begin != vertices.size())
        reader.failAt("lengths", "the lines do not fit their vertices");
    return lines;
}

StoredSurface loadSurface(const JsonReader &reader, ArrayLoader &arrays)
{
    StoredSurface surface;
    surface.mesh = loadMesh(reader.member("mesh"), arrays);
    if (reader.has("triangleRegions")) {
        surface.triangleRegions = loadIndices(reader, "triangleRegions", 1, maxRegion, arrays);
        if (!reader.failed() && surface.triangleRegions.size() != surface.mesh.triangles.size())
            reader.failAt("triangleRegions", "there must be one region a triangle");
    }
    surface.featureLines =
        loadFeatureLines(reader.member("featureLines"), surface.mesh.vertexCount(), arrays);
    for (const JsonReader &element : reader.elements("models", maxStoredModels)) {
        if (element.failed())
            break;
        StoredModel model;
        model.degree = int(element.integer("degree", 0, 16));
        model.coefficients = arrays.load<double>(element, "coefficients", 1);
        model.unknown = element.unknown({"degree", "coefficients"});
        surface.models.push_back(std::move(model));
    }
    surface.unknown = reader.unknown({"mesh", "triangleRegions", "featureLines", "models"});
    return surface;
}

StoredReading loadReading(const JsonReader &reader, ArrayLoader &arrays)
{
    StoredReading reading;
    reading.points = loadPoints(reader, "points", arrays);
    for (const JsonReader &element : reader.elements("models", maxStoredModels)) {
        if (element.failed())
            break;
        StoredReadingModel model;
        model.degree = int(element.integer("degree", 1, maxReadingDegree));
        model.origin = loadTriple(element, "origin");
        model.coefficients = arrays.load<double>(element, "coefficients", 1);
        if (!element.failed() && model.coefficients.size() != readingCoefficients(model.degree))
            element.failAt("coefficients", "there must be one for each monomial");
        model.unknown = element.unknown({"degree", "origin", "coefficients"});
        reading.models.push_back(std::move(model));
    }
    reading.labels = loadIndices(reader, "labels", 1, int(reading.models.size()), arrays);
    if (!reader.failed() && reading.labels.size() != reading.points.size())
        reader.failAt("labels", "there must be one label a point");
    reading.unknown = reader.unknown({"points", "labels", "models"});
    return reading;
}

} // namespace

SketchSurfaceDocument sketchSurfaceFromJson(const JsonReader &reader, ArrayLoader &arrays)
{
    SketchSurfaceDocument document;
    document.strokes.metresPerUnit = reader.number("metresPerUnit", smallestPositive, largest);
    document.strokes.upAxis = reader.oneOf<UpAxis>("upAxis", upAxisNames);
    std::set<StrokeId> ids;
    for (const JsonReader &element : reader.elements("strokes", maxStoredStrokes)) {
        if (element.failed())
            break;
        Stroke stroke = loadStroke(element, arrays);
        if (!ids.insert(stroke.id).second)
            element.failAt("id", "two strokes have the same id");
        UnknownMembers unknown = element.unknown({"id", "role", "points", "pressure", "timeSeconds"});
        if (!unknown.empty())
            document.strokeUnknown.emplace(stroke.id, std::move(unknown));
        document.strokes.strokes.push_back(std::move(stroke));
    }
    document.settings = loadSettings(reader.member("settings"));
    if (reader.has("proxy")) {
        const JsonReader proxy = reader.member("proxy");
        document.proxy = StoredProxy{loadMesh(proxy.member("mesh"), arrays), proxy.unknown({"mesh"})};
    }
    if (reader.has("surface"))
        document.surface = loadSurface(reader.member("surface"), arrays);
    if (reader.has("reading"))
        document.reading = loadReading(reader.member("reading"), arrays);
    document.unknown = reader.unknown({"schema", "version", "minReader", "id", "metresPerUnit", "upAxis",
                                       "strokes", "settings", "proxy", "surface", "reading"});
    return document;
}

} // namespace ductus
