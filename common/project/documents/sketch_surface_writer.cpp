// sketchSurfaceToJson(): first all arrays go into buffers, then the JSON names them.
#include "project/documents/sketch_surface_json.h"

#include "project/documents/sketch_surface_names.h"

namespace ductus {

namespace {

using Handle = BufferPacker::Handle;

constexpr char lengthUnit[] = "sketch"; // metresPerUnit tells how long that is

struct StrokeArrays
{
    Handle points;
    std::optional<Handle> pressure;
    std::optional<Handle> timeSeconds;
};

struct MeshArrays
{
    Handle vertices;
    Handle triangles;
};

template <typename T, typename Value>
std::string_view nameOf(const T &names, Value value)
{
    for (const auto &[name, named] : names) {
        if (named == value)
            return name;
    }
    DUCTUS_ASSERT(!"every value has a name");
    return {};
}

Handle addPoints(const std::vector<Vec3> &points, BufferPacker &packer)
{
    std::vector<double> flat;
    flat.reserve(3 * points.size());
    for (const Vec3 &point : points)
        flat.insert(flat.end(), point.data(), point.data() + 3);
    return packer.add<double>(flat, {points.size(), 3}, lengthUnit);
}

std::optional<Handle> addChannel(const std::vector<double> &values, const char *unit, BufferPacker &packer)
{
    if (values.empty())
        return std::nullopt;
    return packer.add<double>(values, {values.size()}, unit);
}

Handle addIndices(const std::vector<int> &values, BufferPacker &packer)
{
    return packer.add<std::int32_t>(values, {values.size()});
}

MeshArrays addMesh(const TriangleMesh &mesh, BufferPacker &packer)
{
    packer.startBuffer();
    std::vector<std::int32_t> corners;
    corners.reserve(3 * mesh.triangles.size());
    for (const Triangle &triangle : mesh.triangles)
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    const Handle vertices = addPoints(mesh.vertices, packer);
    const Handle triangles = packer.add<std::int32_t>(corners, {mesh.triangles.size(), 3});
    packer.startBuffer();
    return {vertices, triangles};
}

OrderedJson meshJson(const MeshArrays &arrays, const BufferPacker &packer)
{
    return {{"vertices", packer.reference(arrays.vertices).toJson()},
            {"triangles", packer.reference(arrays.triangles).toJson()}};
}

OrderedJson tripleJson(const Vec3 &v)
{
    return {v.x(), v.y(), v.z()};
}

OrderedJson settingsJson(const SurfacingSettings &settings)
{
    OrderedJson json = {{"epsilon", settings.epsilon},
                        {"simplicity", settings.simplicity},
                        {"smoothness", settings.smoothness},
                        {"runs", settings.runs},
                        {"seed", settings.seed}};
    if (settings.symmetryPlane) {
        OrderedJson plane = {{"point", tripleJson(settings.symmetryPlane->point)},
                             {"normal", tripleJson(settings.symmetryPlane->normal)}};
        addUnknown(plane, settings.symmetryPlane->unknown);
        json["symmetryPlane"] = std::move(plane);
    }
    addUnknown(json, settings.unknown);
    return json;
}

struct SurfaceArrays
{
    MeshArrays mesh;
    std::optional<Handle> regions;
    Handle lineLengths;
    Handle lineVertices;
    std::vector<Handle> coefficients; // one a model
};

SurfaceArrays addSurface(const StoredSurface &surface, BufferPacker &packer)
{
    SurfaceArrays arrays;
    arrays.mesh = addMesh(surface.mesh, packer);
    if (!surface.triangleRegions.empty())
        arrays.regions = addIndices(surface.triangleRegions, packer);
    std::vector<int> lengths;
    std::vector<int> vertices;
    for (const std::vector<int> &line : surface.featureLines) {
        lengths.push_back(int(line.size()));
        vertices.insert(vertices.end(), line.begin(), line.end());
    }
    arrays.lineLengths = addIndices(lengths, packer);
    arrays.lineVertices = addIndices(vertices, packer);
    for (const StoredModel &model : surface.models)
        arrays.coefficients.push_back(packer.add<double>(model.coefficients, {model.coefficients.size()}));
    packer.startBuffer();
    return arrays;
}

OrderedJson surfaceJson(const StoredSurface &surface, const SurfaceArrays &arrays, const BufferPacker &packer)
{
    OrderedJson json = {{"mesh", meshJson(arrays.mesh, packer)}};
    if (arrays.regions)
        json["triangleRegions"] = packer.reference(*arrays.regions).toJson();
    json["featureLines"] = {{"lengths", packer.reference(arrays.lineLengths).toJson()},
                            {"vertices", packer.reference(arrays.lineVertices).toJson()}};
    json["models"] = OrderedJson::array();
    for (std::size_t i = 0; i < surface.models.size(); ++i) {
        OrderedJson model = {{"degree", surface.models[i].degree},
                             {"coefficients", packer.reference(arrays.coefficients[i]).toJson()}};
        addUnknown(model, surface.models[i].unknown);
        json["models"].push_back(std::move(model));
    }
    addUnknown(json, surface.unknown);
    return json;
}

struct ReadingArrays
{
    Handle points;
    Handle labels;
    std::vector<Handle> coefficients; // one a model
};

ReadingArrays addReading(const StoredReading &reading, BufferPacker &packer)
{
    packer.startBuffer();
    ReadingArrays arrays{addPoints(reading.points, packer), addIndices(reading.labels, packer), {}};
    for (const StoredReadingModel &model : reading.models)
        arrays.coefficients.push_back(packer.add<double>(model.coefficients, {model.coefficients.size()}));
    packer.startBuffer();
    return arrays;
}

OrderedJson readingJson(const StoredReading &reading, const ReadingArrays &arrays, const BufferPacker &packer)
{
    OrderedJson json = {{"points", packer.reference(arrays.points).toJson()},
                        {"labels", packer.reference(arrays.labels).toJson()},
                        {"models", OrderedJson::array()}};
    for (std::size_t i = 0; i < reading.models.size(); ++i) {
        OrderedJson model = {{"degree", reading.models[i].degree},
                             {"origin", tripleJson(reading.models[i].origin)},
                             {"coefficients", packer.reference(arrays.coefficients[i]).toJson()}};
        addUnknown(model, reading.models[i].unknown);
        json["models"].push_back(std::move(model));
    }
    addUnknown(json, reading.unknown);
    return json;
}

OrderedJson strokeJson(const Stroke &stroke, const StrokeArrays &arrays, const BufferPacker &packer)
{
    OrderedJson json = {{"id", stroke.id.value},
                        {"role", nameOf(strokeRoleNames, stroke.role)},
                        {"points", packer.reference(arrays.points).toJson()}};
    if (arrays.pressure)
        json["pressure"] = packer.reference(*arrays.pressure).toJson();
    if (arrays.timeSeconds)
        json["timeSeconds"] = packer.reference(*arrays.timeSeconds).toJson();
    return json;
}

} // namespace

OrderedJson sketchSurfaceToJson(const SketchSurfaceDocument &document, const Uuid &id, BufferPacker &packer)
{
    std::vector<StrokeArrays> strokeArrays;
    for (const Stroke &stroke : document.strokes.strokes) {
        const Handle points = addPoints(stroke.points, packer);
        strokeArrays.push_back(
            {points, addChannel(stroke.pressure, "", packer), addChannel(stroke.timeSeconds, "s", packer)});
    }
    packer.startBuffer();
    std::optional<MeshArrays> proxyArrays;
    if (document.proxy)
        proxyArrays = addMesh(document.proxy->mesh, packer);
    std::optional<SurfaceArrays> surfaceArrays;
    if (document.surface)
        surfaceArrays = addSurface(*document.surface, packer);
    std::optional<ReadingArrays> readingArrays;
    if (document.reading)
        readingArrays = addReading(*document.reading, packer);
    packer.finish();

    OrderedJson json = {{"schema", sketchSurfaceKind},
                        {"version", sketchSurfaceVersion},
                        {"minReader", 1},
                        {"id", id.text()},
                        {"metresPerUnit", document.strokes.metresPerUnit},
                        {"upAxis", nameOf(upAxisNames, document.strokes.upAxis)},
                        {"strokes", OrderedJson::array()},
                        {"settings", settingsJson(document.settings)}};
    for (std::size_t i = 0; i < strokeArrays.size(); ++i) {
        const Stroke &stroke = document.strokes.strokes[i];
        OrderedJson member = strokeJson(stroke, strokeArrays[i], packer);
        if (const auto found = document.strokeUnknown.find(stroke.id); found != document.strokeUnknown.end())
            addUnknown(member, found->second);
        json["strokes"].push_back(std::move(member));
    }
    if (document.proxy) {
        json["proxy"] = {{"mesh", meshJson(*proxyArrays, packer)}};
        addUnknown(json["proxy"], document.proxy->unknown);
    }
    if (document.surface)
        json["surface"] = surfaceJson(*document.surface, *surfaceArrays, packer);
    if (document.reading)
        json["reading"] = readingJson(*document.reading, *readingArrays, packer);
    addUnknown(json, document.unknown);
    return json;
}

} // namespace ductus
