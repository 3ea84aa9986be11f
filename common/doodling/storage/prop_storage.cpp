#include "doodling/storage/prop_storage.h"

#include "painting/storage/painting_json.h"
#include "painting/storage/property_json.h"

namespace ductus {

OrderedJson propJsonWithSlots(const Prop &prop, BufferPacker &packer)
{
    packer.startBuffer(); // what was drawn may change without the painting
    OrderedJson json = {{"link", linkJson(prop.link)},
                        {"look", prop.look},
                        {"placement", placementJson(prop.placement)},
                        {"framesPerSecond", prop.framesPerSecond},
                        {"painting", paintingWithSlots(prop.painting->painting(), prop.painting->unknown(),
                                                       prop.link.document, packer)}};
    return json;
}

std::shared_ptr<const Prop> propFromJson(const JsonReader &reader, ArrayLoader &arrays)
{
    auto prop = std::make_shared<Prop>();
    prop->link = linkFromJson(reader.member("link"));
    prop->look = reader.string("look", maxPaintingText);
    prop->placement = readPlacement(reader);
    prop->framesPerSecond = reader.number("framesPerSecond", 0.0, 1e6);
    if (!reader.failed() && prop->placement.mirrored)
        reader.failAt("placement", "a prop is not mirrored");
    if (reader.failed())
        return nullptr;
    const JsonReader content = reader.member("painting");
    if (content.integer("version", 1, INT32_MAX) != paintingVersion) {
        content.failAt("version", "this version of paintings is not known here", ErrorCode::NewerVersion);
        return nullptr;
    }
    UnknownPaintingMembers unknown;
    Painting painting = paintingFromJson(content, arrays, unknown);
    if (reader.failed())
        return nullptr;
    prop->painting = std::make_shared<const PaintingContent>(std::move(painting), std::move(unknown));
    return prop;
}

std::string storedPropProblem(const Prop &prop)
{
    if (std::string problem = propProblem(prop); !problem.empty())
        return problem;
    const Result<void> checked = prop.painting->check("");
    return checked ? std::string() : checked.error().problem;
}

} // namespace ductus
