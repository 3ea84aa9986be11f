#include "painting/action/action_json.h"

#include "painting/storage/painting_json.h"
#include "painting/storage/painting_names.h"
#include "painting/storage/property_json.h"

#include <limits>

namespace ductus {

namespace {

using Shapes = std::vector<std::shared_ptr<const ElementShape>>;

constexpr double largest = std::numeric_limits<double>::max();
constexpr std::size_t maxPoints = 10'000'000;

// Words of the sections; the file has numbers.
constexpr PaintingWords<StrokeSection> sectionNames[] = {{"round", StrokeSection::Round},
                                                         {"ellipse", StrokeSection::Ellipse},
                                                         {"cube", StrokeSection::Cube},
                                                         {"ribbon", StrokeSection::Ribbon}};
constexpr int numbersAPoint = 11; // position, normal, half width, colour, opacity

PropertyJsonWriter propertyWriter()
{
    return {nullptr, [](const std::vector<std::uint8_t> &bytes) { return OrderedJson(bytes); }};
}

PropertyJsonReader propertyReader()
{
    return {nullptr, [](const JsonReader &owner, std::string_view key) {
                std::vector<std::uint8_t> bytes;
                for (const std::uint64_t value : owner.unsignedIntegers(key, maxPoints)) {
                    if (value > 255)
                        owner.failAt(key, "the values are 0 to 255");
                    bytes.push_back(std::uint8_t(value));
                }
                return bytes;
            }};
}

OrderedJson strokeJson(const StrokeShape &stroke)
{
    OrderedJson points = OrderedJson::array();
    for (const PaintedPoint &p : stroke.points)
        points.push_back({p.position[0], p.position[1], p.position[2], p.normal[0], p.normal[1], p.normal[2],
                          p.halfWidth, p.colour[0], p.colour[1], p.colour[2], p.opacity});
    return {{"section", wordOf(sectionNames, stroke.section)}, {"points", std::move(points)}};
}

OrderedJson meshJson(const MeshShape &shape)
{
    OrderedJson vertices = OrderedJson::array(), triangles = OrderedJson::array(),
                colours = OrderedJson::array();
    for (const Vec3 &vertex : shape.mesh.vertices)
        vertices.push_back(tripleJson(vertex));
    for (const Triangle &triangle : shape.mesh.triangles)
        triangles.push_back({triangle[0], triangle[1], triangle[2]});
    for (const Eigen::Vector3f &colour : shape.vertexColours)
        colours.push_back(tripleJson(colour));
    OrderedJson json = {{"vertices", std::move(vertices)},
                        {"triangles", std::move(triangles)},
                        {"colours", std::move(colours)}};
    if (shape.link)
        json["link"] = linkJson(*shape.link);
    return json;
}

class FieldWriter
{
public:
    template <typename Tag>
    void object(const char *key, TypedId<Tag> id)
    {
        objects[key] = id.value;
    }
    void object(const char *key, const std::vector<ElementId> &ids)
    {
        objects[key] = OrderedJson::array();
        for (const ElementId id : ids)
            objects[key].push_back(id.value);
    }

    void parameter(const char *key, const std::string &value) { parameters[key] = value; }
    void parameter(const char *key, double value) { parameters[key] = value; }
    void parameter(const char *key, bool value) { parameters[key] = value; }
    // Positions at the end and first drawings are the rule.
    void parameter(const char *key, int value)
    {
        const int usual = std::string_view(key) == "position" ? -1 : 0;
        if (value != usual)
            parameters[key] = value;
    }
    void parameter(const char *key, BlendMode value) { parameters[key] = blendModeName(value); }
    void parameter(const char *key, BlendSpace value) { parameters[key] = wordOf(blendSpaceNames, value); }
    void parameter(const char *key, ToleranceMode value)
    {
        parameters[key] = wordOf(toleranceModeNames, value);
    }
    void parameter(const char *key, const Eigen::Vector3f &value) { parameters[key] = tripleJson(value); }
    void parameter(const char *key, const Placement &value)
    {
        if (!(value == Placement()))
            parameters[key] = placementJson(value);
    }
    void parameter(const char *key, const std::vector<Mask> &value)
    {
        parameters[key] = OrderedJson::array();
        for (const Mask &mask : value)
            parameters[key].push_back(propertyWriter().mask(mask));
    }
    void parameter(const char *key, const std::vector<PlacementKey> &value)
    {
        parameters[key] = propertyWriter().keys(value, "");
    }
    void parameter(const char *key, const std::vector<CameraKey> &value)
    {
        parameters[key] = OrderedJson::array();
        for (const CameraKey &each : value)
            parameters[key].push_back({{"timeSeconds", each.timeSeconds},
                                       {"eye", tripleJson(each.eye)},
                                       {"rotation", rotationJson(each.rotation)},
                                       {"verticalViewDegrees", each.verticalViewDegrees},
                                       {"interpolation", wordOf(interpolationNames, each.interpolation)}});
    }
    void parameter(const char *key, const std::vector<std::pair<double, double>> &value)
    {
        parameters[key] = OrderedJson::array();
        for (const auto &[from, to] : value)
            parameters[key].push_back({{"from", from}, {"to", to}});
    }
    void parameter(const char *key, const Shapes &value)
    {
        parameters[key] = OrderedJson::array();
        for (const auto &shape : value) {
            const auto *stroke = std::get_if<StrokeShape>(shape.get());
            parameters[key].push_back(stroke ? strokeJson(*stroke) : meshJson(std::get<MeshShape>(*shape)));
        }
    }
    template <typename T>
    void parameter(const char *key, const std::optional<T> &value)
    {
        if (value)
            parameter(key, *value);
    }

    OrderedJson objects = OrderedJson::object();
    OrderedJson parameters = OrderedJson::object();
};

std::shared_ptr<const ElementShape> readStroke(const JsonReader &reader)
{
    StrokeShape stroke;
    stroke.section = reader.oneOf<StrokeSection>("section", sectionNames);
    for (const std::vector<double> &row : reader.rows("points", maxPoints, numbersAPoint)) {
        const auto at = [&](int i) { return float(row[std::size_t(i)]); };
        stroke.points.push_back(
            {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, at(6), {at(7), at(8), at(9)}, at(10)});
    }
    return std::make_shared<const ElementShape>(std::move(stroke));
}

std::shared_ptr<const ElementShape> readMesh(const JsonReader &reader)
{
    MeshShape shape;
    for (const auto &row : reader.rows("vertices", maxPoints, 3))
        shape.mesh.vertices.emplace_back(row[0], row[1], row[2]);
    for (const auto &row : reader.rows("triangles", maxPoints, 3)) {
        Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            const bool isIndex = row[k] >= 0 && row[k] < double(shape.mesh.vertices.size());
            if (!isIndex)
                reader.failAt("triangles", "there is no such vertex");
            triangle[k] = isIndex ? int(row[k]) : 0;
        }
        shape.mesh.triangles.push_back(triangle);
    }
    for (const auto &row : reader.rows("colours", maxPoints, 3))
        shape.vertexColours.emplace_back(float(row[0]), float(row[1]), float(row[2]));
    if (reader.has("link"))
        shape.link = linkFromJson(reader.member("link"));
    return std::make_shared<const ElementShape>(std::move(shape));
}

class FieldReader
{
public:
    FieldReader(JsonReader objects, JsonReader parameters)
        : mObjects(std::move(objects)), mParameters(std::move(parameters))
    {
    }

    template <typename Tag>
    void object(const char *key, TypedId<Tag> &id)
    {
        id.value = std::int32_t(mObjects.integer(key, 0, INT32_MAX));
    }
    void object(const char *key, std::vector<ElementId> &ids)
    {
        for (const std::uint64_t id : mObjects.unsignedIntegers(key, maxPaintingParts)) {
            if (id > INT32_MAX)
                mObjects.failAt(key, "this is not an id");
            ids.push_back(ElementId{std::int32_t(id)});
        }
    }

    void parameter(const char *key, std::string &value) { value = mParameters.string(key, maxPaintingText); }
    void parameter(const char *key, double &value) { value = mParameters.number(key, -largest, largest); }
    void parameter(const char *key, bool &value) { value = mParameters.boolean(key); }
    void parameter(const char *key, int &value)
    {
        if (mParameters.has(key))
            value = int(mParameters.integer(key, -1, INT32_MAX));
    }
    void parameter(const char *key, BlendMode &value)
    {
        value = mParameters.oneOf<BlendMode>(key, blendModeNames());
    }
    void parameter(const char *key, BlendSpace &value)
    {
        value = mParameters.oneOf<BlendSpace>(key, blendSpaceNames);
    }
    void parameter(const char *key, ToleranceMode &value)
    {
        value = mParameters.oneOf<ToleranceMode>(key, toleranceModeNames);
    }
    void parameter(const char *key, Eigen::Vector3f &value)
    {
        value = readTriple(mParameters, key).cast<float>();
    }
    void parameter(const char *key, Placement &value)
    {
        if (mParameters.has(key))
            value = readPlacementOf(mParameters.member(key));
    }
    void parameter(const char *key, std::vector<Mask> &value)
    {
        for (const JsonReader &mask : mParameters.elements(key, maxPaintingParts))
            value.push_back(propertyReader().mask(mask, ""));
    }
    void parameter(const char *key, std::vector<PlacementKey> &value)
    {
        value = propertyReader().keys(mParameters, key, "");
    }
    void parameter(const char *key, std::vector<CameraKey> &value)
    {
        for (const JsonReader &each : mParameters.elements(key, maxPaintingParts))
            value.push_back({each.number("timeSeconds", -largest, largest), readTriple(each, "eye"),
                             readRotation(each), each.number("verticalViewDegrees", 1, 170),
                             each.oneOf<KeyInterpolation>("interpolation", interpolationNames)});
    }
    void parameter(const char *key, std::vector<std::pair<double, double>> &value)
    {
        for (const JsonReader &each : mParameters.elements(key, maxPaintingParts))
            value.emplace_back(each.number("from", 0, largest), each.number("to", 0, largest));
    }
    void parameter(const char *key, Shapes &value)
    {
        for (const JsonReader &each : mParameters.elements(key, maxPaintingParts))
            value.push_back(each.has("vertices") ? readMesh(each) : readStroke(each));
    }
    template <typename T>
    void parameter(const char *key, std::optional<T> &value)
    {
        if (mParameters.has(key))
            parameter(key, value.emplace());
    }

private:
    JsonReader mObjects;
    JsonReader mParameters;
};

template <std::size_t i = 0>
PaintingAction readAction(const JsonReader &reader, const std::string &word)
{
    if constexpr (i < std::variant_size_v<PaintingAction>) {
        using Action = std::variant_alternative_t<i, PaintingAction>;
        if (word != Action::word)
            return readAction<i + 1>(reader, word);
        Action action;
        FieldReader fields(reader.member("objects"), reader.member("parameters"));
        action.fields(fields);
        return action;
    } else {
        reader.failAt("action", "there is no action \"" + word + "\"");
        return {};
    }
}

} // namespace

OrderedJson actionToJson(const PaintingAction &action)
{
    FieldWriter writer;
    std::visit([&](auto copy) { copy.fields(writer); }, action);
    return {{"action", actionWord(action)},
            {"objects", std::move(writer.objects)},
            {"parameters", std::move(writer.parameters)}};
}

PaintingAction actionFromJson(const JsonReader &reader)
{
    return readAction(reader, reader.string("action", 64));
}

} // namespace ductus
