// paintingFromJson(): every field checked, nothing believed; at the end the invariants of the whole.
#include "painting/storage/painting_json.h"

#include "painting/scene/painting_check.h"
#include "painting/storage/painting_names.h"
#include "painting/storage/property_json.h"
#include "painting/storage/shape_blocks.h"
#include "painting/storage/unknown_places.h"

#include <limits>

namespace ductus {

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallestPositive = std::numeric_limits<double>::denorm_min();
constexpr std::int64_t largestId = std::numeric_limits<std::int32_t>::max();

class PaintingParser
{
public:
    PaintingParser(const JsonReader &reader, ArrayLoader &arrays, UnknownPaintingMembers &unknown)
        : mReader(reader), mArrays(arrays), mUnknown(unknown),
          mProperties(&unknown, [&arrays](const JsonReader &owner, std::string_view key) {
              return arrays.load<std::uint8_t>(owner, key, 1);
          })
    {
    }

    Painting parse();

private:
    void keep(const JsonReader &object, const std::string &place,
              std::initializer_list<std::string_view> known)
    {
        mProperties.keep(object, place, known);
    }

    // Calls \a read for the elements of an array until something is wrong.
    template <typename Read>
    void forEach(const JsonReader &owner, std::string_view key, Read read)
    {
        const std::vector<JsonReader> all = owner.elements(key, maxPaintingParts);
        for (std::size_t i = 0; i < all.size() && !mReader.failed(); ++i)
            read(all[i], i, all.size());
    }

    std::int32_t readId(const JsonReader &object, std::string_view key = "id")
    {
        return std::int32_t(object.integer(key, 0, largestId));
    }

    Stack readStack(const JsonReader &reader);
    Layer readLayer(const JsonReader &reader);
    Drawing readDrawing(const JsonReader &reader, const std::string &place);
    LayerFrames readFrames(const JsonReader &reader, const std::string &place);
    Look readLook(const JsonReader &reader);
    MotionGroup readGroup(const JsonReader &reader);
    CameraPath readCamera(const JsonReader &reader);
    ReferencePicture readPicture(const JsonReader &reader);
    void readScene(Painting &painting);

    const JsonReader &mReader;
    ArrayLoader &mArrays;
    UnknownPaintingMembers &mUnknown;
    PropertyJsonReader mProperties;
    std::vector<std::shared_ptr<const ElementShape>> mShapes;
};

Drawing PaintingParser::readDrawing(const JsonReader &reader, const std::string &place)
{
    Drawing drawing;
    if (!reader.has("ids"))
        return drawing;
    const std::vector<std::int32_t> ids = mArrays.load<std::int32_t>(reader, "ids", 1);
    const std::vector<std::int32_t> shapes = mArrays.load<std::int32_t>(reader, "shapes", 1);
    std::vector<double> placements;
    if (reader.has("placements"))
        placements = mArrays.load<double>(reader, "placements", 9);
    if (shapes.size() != ids.size())
        reader.failAt("shapes", "there must be one shape an element");
    if (!placements.empty() && placements.size() != 9 * ids.size())
        reader.failAt("placements", "there must be one placement an element");
    if (reader.failed())
        return drawing;
    drawing.elements.resize(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        Element &element = drawing.elements[i];
        if (shapes[i] < 0 || std::size_t(shapes[i]) >= mShapes.size()) {
            reader.failAt("shapes", "there is no shape " + std::to_string(shapes[i]));
            return {};
        }
        element.id.value = ids[i];
        element.shape = mShapes[std::size_t(shapes[i])];
        if (placements.empty())
            continue;
        const double *row = &placements[9 * i];
        element.placement.rotation = {row[3], row[0], row[1], row[2]};
        element.placement.scale = row[4];
        element.placement.mirrored = row[5] != 0;
        element.placement.translation = {row[6], row[7], row[8]};
    }
    keep(reader, columnPlace(place, ids), {"ids", "shapes", "placements"});
    return drawing;
}

LayerFrames PaintingParser::readFrames(const JsonReader &reader, const std::string &place)
{
    LayerFrames frames;
    frames.framesPerSecond = reader.number("perSecond", smallestPositive, largest);
    frames.repeatCount = int(reader.integer("repeatCount", 0, largestId));
    const auto drawings = mArrays.load<std::int32_t>(reader, "drawings", 1);
    frames.drawingOfFrame.assign(drawings.begin(), drawings.end());
    keep(reader, place, {"perSecond", "repeatCount", "drawings"});
    return frames;
}

Layer PaintingParser::readLayer(const JsonReader &reader)
{
    Layer layer;
    layer.id.value = readId(reader);
    const std::string place = idPlace("layer", layer.id.value);
    layer.name = reader.string("name", maxPaintingText);
    layer.locked = reader.boolean("locked");
    layer.properties = mProperties.properties(reader.member("properties"), place + "/properties");
    layer.tolerance = reader.number("tolerance", 0, largest);
    layer.toleranceMode = reader.oneOf<ToleranceMode>("toleranceMode", toleranceModeNames);
    layer.drawings.clear();
    forEach(reader, "drawings", [&](const JsonReader &drawing, std::size_t, std::size_t) {
        layer.drawings.push_back(readDrawing(drawing, place));
    });
    layer.frames = readFrames(reader.member("frames"), place + "/frames");
    layer.motion = mProperties.keys(reader, "motion", place);
    keep(
        reader, place,
        {"id", "name", "locked", "properties", "tolerance", "toleranceMode", "drawings", "frames", "motion"});
    return layer;
}

Stack PaintingParser::readStack(const JsonReader &reader)
{
    Stack stack;
    stack.id.value = readId(reader);
    stack.name = reader.string("name", maxPaintingText);
    if (reader.has("substrate"))
        stack.substrate = readLayer(reader.member("substrate"));
    forEach(reader, "appearance", [&](const JsonReader &layer, std::size_t, std::size_t) {
        stack.appearance.push_back(readLayer(layer));
    });
    keep(reader, idPlace("stack", stack.id.value), {"id", "name", "substrate", "appearance"});
    return stack;
}

Look PaintingParser::readLook(const JsonReader &reader)
{
    Look look;
    look.id.value = readId(reader);
    const std::string place = idPlace("look", look.id.value);
    look.name = reader.string("name", maxPaintingText);
    forEach(reader, "layers", [&](const JsonReader &entry, std::size_t, std::size_t) {
        const LayerId layer{readId(entry, "layer")};
        const std::string layerPlace = place + "/" + idPlace("layer", layer.value);
        look.layers.emplace_back(
            layer, mProperties.properties(entry.member("properties"), layerPlace + "/properties"));
        keep(entry, layerPlace, {"layer", "properties"});
    });
    keep(reader, place, {"id", "name", "layers"});
    return look;
}

MotionGroup PaintingParser::readGroup(const JsonReader &reader)
{
    MotionGroup group;
    group.id.value = readId(reader);
    const std::string place = idPlace("group", group.id.value);
    group.name = reader.string("name", maxPaintingText);
    for (const std::int32_t id : mArrays.load<std::int32_t>(reader, "elements", 1))
        group.elements.push_back(ElementId{id});
    group.keys = mProperties.keys(reader, "keys", place);
    keep(reader, place, {"id", "name", "elements", "keys"});
    return group;
}

CameraPath PaintingParser::readCamera(const JsonReader &reader)
{
    CameraPath path;
    forEach(reader, "keys", [&](const JsonReader &key, std::size_t i, std::size_t count) {
        path.keys.push_back({key.number("timeSeconds", -largest, largest), readTriple(key, "eye"),
                             readRotation(key), key.number("verticalViewDegrees", 1, 170),
                             key.oneOf<KeyInterpolation>("interpolation", interpolationNames)});
        keep(key, listPlace("camera", "key", i, count),
             {"timeSeconds", "eye", "rotation", "verticalViewDegrees", "interpolation"});
    });
    keep(reader, "camera", {"keys"});
    return path;
}

ReferencePicture PaintingParser::readPicture(const JsonReader &reader)
{
    ReferencePicture picture;
    picture.id.value = readId(reader);
    picture.name = reader.string("name", maxPaintingText);
    picture.visible = reader.boolean("visible");
    picture.opacity = reader.number("opacity", 0, 1);
    picture.placement = readPlacement(reader);
    auto image = std::make_shared<Image>();
    image->width = int(reader.integer("width", 1, maxPictureSide));
    image->height = int(reader.integer("height", 1, maxPictureSide));
    image->pixels = mArrays.load<std::uint8_t>(reader, "pixels", 1);
    if (image->pixels.size() != std::size_t(image->width) * std::size_t(image->height) * 4)
        reader.failAt("pixels", "there must be four values a pixel");
    picture.image = std::move(image);
    keep(reader, idPlace("picture", picture.id.value),
         {"id", "name", "visible", "opacity", "placement", "width", "height", "pixels"});
    return picture;
}

void PaintingParser::readScene(Painting &painting)
{
    painting.nextId = std::int32_t(mReader.integer("nextId", 1, largestId));
    painting.metresPerUnit = mReader.number("metresPerUnit", smallestPositive, largest);
    painting.blendSpace = mReader.oneOf<BlendSpace>("blendSpace", blendSpaceNames);
    painting.background = readTriple(mReader, "background").cast<float>();
    painting.loopSeconds = mReader.number("loopSeconds", 0, largest);
    mShapes = readShapeBlocks(mReader, "shapes", mArrays, mUnknown);
    forEach(mReader, "stacks", [&](const JsonReader &stack, std::size_t, std::size_t) {
        painting.stacks.push_back(readStack(stack));
    });
    painting.sceneStack = readStack(mReader.member("sceneStack"));
    forEach(mReader, "looks", [&](const JsonReader &look, std::size_t, std::size_t) {
        painting.looks.push_back(readLook(look));
    });
    forEach(mReader, "motionGroups", [&](const JsonReader &group, std::size_t, std::size_t) {
        painting.motionGroups.push_back(readGroup(group));
    });
    painting.camera = readCamera(mReader.member("camera"));
    forEach(mReader, "pictures", [&](const JsonReader &picture, std::size_t, std::size_t) {
        painting.pictures.push_back(readPicture(picture));
    });
    keep(mReader, "",
         {"schema", "version", "minReader", "id", "nextId", "metresPerUnit", "blendSpace", "background",
          "loopSeconds", "shapes", "stacks", "sceneStack", "looks", "motionGroups", "camera", "pictures"});
}

Painting PaintingParser::parse()
{
    Painting painting;
    readScene(painting);
    if (mReader.failed())
        return {};
    if (const Result<void> checked = checkPainting(painting); !checked) {
        mReader.fail(checked.error().problem + " (" + checked.error().place + ")");
        return {};
    }
    return painting;
}

} // namespace

Painting paintingFromJson(const JsonReader &reader, ArrayLoader &arrays, UnknownPaintingMembers &unknown)
{
    return PaintingParser(reader, arrays, unknown).parse();
}

} // namespace ductus
