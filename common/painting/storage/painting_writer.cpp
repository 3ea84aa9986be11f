// paintingToJson(): the objects of a painting one by one, arrays by slots that are resolved at the end.
#include "painting/storage/painting_json.h"

#include "painting/storage/array_slots.h"
#include "painting/storage/painting_names.h"
#include "painting/storage/property_json.h"
#include "painting/storage/shape_blocks.h"
#include "painting/storage/unknown_places.h"

namespace ductus {

namespace {

class PaintingWriter
{
public:
    PaintingWriter(const Painting &painting, const UnknownPaintingMembers &unknown, BufferPacker &packer)
        : mPainting(painting), mPacker(packer), mShapes(packer, unknown),
          mProperties(&unknown,
                      [&packer](const std::vector<std::uint8_t> &bytes) { return addArray(packer, bytes); })
    {
    }

    OrderedJson write(const Uuid &id);

private:
    OrderedJson kept(OrderedJson object, const std::string &place) const
    {
        return mProperties.kept(std::move(object), place);
    }

    OrderedJson stackJson(const Stack &stack);
    OrderedJson layerJson(const Layer &layer);
    OrderedJson drawingJson(const Drawing &drawing, const std::string &place);
    OrderedJson lookJson(const Look &look);
    OrderedJson groupJson(const MotionGroup &group);
    OrderedJson cameraJson() const;
    OrderedJson pictureJson(const ReferencePicture &picture);

    const Painting &mPainting;
    BufferPacker &mPacker;
    ShapeBlockWriter mShapes;
    PropertyJsonWriter mProperties;
};

OrderedJson PaintingWriter::drawingJson(const Drawing &drawing, const std::string &place)
{
    OrderedJson json = OrderedJson::object();
    if (drawing.elements.empty())
        return json;
    mShapes.add(drawing);
    std::vector<std::int32_t> ids, shapes;
    std::vector<double> placements;
    bool isAnyPlaced = false;
    for (const Element &element : drawing.elements) {
        ids.push_back(element.id.value);
        shapes.push_back(mShapes.numberOf(*element.shape));
        const Placement &p = element.placement;
        isAnyPlaced = isAnyPlaced || !(p == Placement());
        const double row[] = {p.rotation.x(),    p.rotation.y(),    p.rotation.z(),
                              p.rotation.w(),    p.scale,           p.mirrored ? 1.0 : 0.0,
                              p.translation.x(), p.translation.y(), p.translation.z()};
        placements.insert(placements.end(), std::begin(row), std::end(row));
    }
    json["ids"] = addArray(mPacker, ids);
    json["shapes"] = addArray(mPacker, shapes);
    if (isAnyPlaced)
        json["placements"] = addArray(mPacker, placements, 9);
    return kept(std::move(json), columnPlace(place, ids));
}

OrderedJson PaintingWriter::layerJson(const Layer &layer)
{
    const std::string place = idPlace("layer", layer.id.value);
    OrderedJson json = {{"id", layer.id.value},
                        {"name", layer.name},
                        {"locked", layer.locked},
                        {"properties", mProperties.properties(layer.properties, place + "/properties")},
                        {"tolerance", layer.tolerance},
                        {"toleranceMode", wordOf(toleranceModeNames, layer.toleranceMode)},
                        {"drawings", OrderedJson::array()}};
    for (const Drawing &drawing : layer.drawings)
        json["drawings"].push_back(drawingJson(drawing, place));
    const std::vector<std::int32_t> frames(layer.frames.drawingOfFrame.begin(),
                                           layer.frames.drawingOfFrame.end());
    json["frames"] = kept({{"perSecond", layer.frames.framesPerSecond},
                           {"repeatCount", layer.frames.repeatCount},
                           {"drawings", addArray(mPacker, frames)}},
                          place + "/frames");
    json["motion"] = mProperties.keys(layer.motion, place);
    return kept(std::move(json), place);
}

OrderedJson PaintingWriter::stackJson(const Stack &stack)
{
    OrderedJson json = {{"id", stack.id.value}, {"name", stack.name}};
    if (stack.substrate)
        json["substrate"] = layerJson(*stack.substrate);
    json["appearance"] = OrderedJson::array();
    for (const Layer &layer : stack.appearance)
        json["appearance"].push_back(layerJson(layer));
    return kept(std::move(json), idPlace("stack", stack.id.value));
}

OrderedJson PaintingWriter::lookJson(const Look &look)
{
    const std::string place = idPlace("look", look.id.value);
    OrderedJson json = {{"id", look.id.value}, {"name", look.name}, {"layers", OrderedJson::array()}};
    for (const auto &[layer, properties] : look.layers) {
        const std::string layerPlace = place + "/" + idPlace("layer", layer.value);
        json["layers"].push_back(
            kept({{"layer", layer.value},
                  {"properties", mProperties.properties(properties, layerPlace + "/properties")}},
                 layerPlace));
    }
    return kept(std::move(json), place);
}

OrderedJson PaintingWriter::groupJson(const MotionGroup &group)
{
    const std::string place = idPlace("group", group.id.value);
    std::vector<std::int32_t> elements;
    for (const ElementId element : group.elements)
        elements.push_back(element.value);
    return kept({{"id", group.id.value},
                 {"name", group.name},
                 {"elements", addArray(mPacker, elements)},
                 {"keys", mProperties.keys(group.keys, place)}},
                place);
}

OrderedJson PaintingWriter::cameraJson() const
{
    OrderedJson keys = OrderedJson::array();
    const std::vector<CameraKey> &all = mPainting.camera.keys;
    for (std::size_t i = 0; i < all.size(); ++i)
        keys.push_back(kept({{"timeSeconds", all[i].timeSeconds},
                             {"eye", tripleJson(all[i].eye)},
                             {"rotation", rotationJson(all[i].rotation)},
                             {"verticalViewDegrees", all[i].verticalViewDegrees},
                             {"interpolation", wordOf(interpolationNames, all[i].interpolation)}},
                            listPlace("camera", "key", i, all.size())));
    return kept({{"keys", std::move(keys)}}, "camera");
}

OrderedJson PaintingWriter::pictureJson(const ReferencePicture &picture)
{
    mPacker.startBuffer();
    OrderedJson json = {{"id", picture.id.value},
                        {"name", picture.name},
                        {"visible", picture.visible},
                        {"opacity", picture.opacity},
                        {"placement", placementJson(picture.placement)},
                        {"width", picture.image->width},
                        {"height", picture.image->height},
                        {"pixels", addArray(mPacker, picture.image->pixels)}};
    mPacker.startBuffer();
    return kept(std::move(json), idPlace("picture", picture.id.value));
}

OrderedJson PaintingWriter::write(const Uuid &id)
{
    OrderedJson json = {{"schema", paintingKindName},
                        {"version", paintingVersion},
                        {"minReader", 1},
                        {"id", id.text()},
                        {"nextId", mPainting.nextId},
                        {"metresPerUnit", mPainting.metresPerUnit},
                        {"blendSpace", wordOf(blendSpaceNames, mPainting.blendSpace)},
                        {"background", tripleJson(mPainting.background)},
                        {"loopSeconds", mPainting.loopSeconds},
                        {"stacks", OrderedJson::array()}};
    for (const Stack &stack : mPainting.stacks)
        json["stacks"].push_back(stackJson(stack));
    json["sceneStack"] = stackJson(mPainting.sceneStack);
    json["shapes"] = mShapes.takeBlocks();
    json["looks"] = OrderedJson::array();
    for (const Look &look : mPainting.looks)
        json["looks"].push_back(lookJson(look));
    json["motionGroups"] = OrderedJson::array();
    for (const MotionGroup &group : mPainting.motionGroups)
        json["motionGroups"].push_back(groupJson(group));
    json["camera"] = cameraJson();
    json["pictures"] = OrderedJson::array();
    for (const ReferencePicture &picture : mPainting.pictures)
        json["pictures"].push_back(pictureJson(picture));
    return kept(std::move(json), "");
}

} // namespace

OrderedJson paintingToJson(const Painting &painting, const UnknownPaintingMembers &unknown, const Uuid &id,
                           BufferPacker &packer)
{
    OrderedJson json = paintingWithSlots(painting, unknown, id, packer);
    packer.finish();
    resolveArrays(json, packer);
    return json;
}

OrderedJson paintingWithSlots(const Painting &painting, const UnknownPaintingMembers &unknown, const Uuid &id,
                              BufferPacker &packer)
{
    return PaintingWriter(painting, unknown, packer).write(id);
}

} // namespace ductus
