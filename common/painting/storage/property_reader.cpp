// PropertyJsonReader: every field checked.
#include "painting/storage/painting_json.h"
#include "painting/storage/painting_names.h"
#include "painting/storage/property_json.h"
#include "painting/storage/unknown_places.h"

#include <limits>

namespace ductus {

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallestPositive = std::numeric_limits<double>::denorm_min();

template <typename Read>
void forEach(const JsonReader &owner, std::string_view key, Read read)
{
    const std::vector<JsonReader> all = owner.elements(key, maxPaintingParts);
    for (std::size_t i = 0; i < all.size() && !owner.failed(); ++i)
        read(all[i], i, all.size());
}

} // namespace

Vec3 readTriple(const JsonReader &reader, std::string_view key)
{
    const std::array<double, 3> values = reader.triple(key);
    return {values[0], values[1], values[2]};
}

Eigen::Quaterniond readRotation(const JsonReader &reader)
{
    const std::vector<double> q = reader.numbers("rotation", 4);
    return {q[3], q[0], q[1], q[2]};
}

Placement readPlacement(const JsonReader &owner)
{
    return readPlacementOf(owner.member("placement"));
}

Placement readPlacementOf(const JsonReader &reader)
{
    Placement placement;
    placement.rotation = readRotation(reader);
    placement.scale = reader.number("scale", smallestPositive, largest);
    placement.mirrored = reader.boolean("mirrored");
    placement.translation = readTriple(reader, "translation");
    return placement;
}

void PropertyJsonReader::keep(const JsonReader &object, const std::string &place,
                              std::initializer_list<std::string_view> known) const
{
    if (!mUnknown)
        return;
    if (UnknownMembers members = object.unknown(known); !members.empty())
        mUnknown->emplace(place, std::move(members));
}

TextureMask PropertyJsonReader::texture(const JsonReader &reader) const
{
    TextureMask result;
    result.placement = readPlacement(reader);
    result.width = int(reader.integer("width", 1, 4096));
    result.height = int(reader.integer("height", 1, 4096));
    result.depth = int(reader.integer("depth", 1, 4096));
    result.values = std::make_shared<const std::vector<std::uint8_t>>(mBytes(reader, "values"));
    return result;
}

Mask PropertyJsonReader::mask(const JsonReader &reader, const std::string &place) const
{
    Mask result;
    result.enabled = reader.boolean("enabled");
    result.inverted = reader.boolean("inverted");
    switch (reader.oneOf<MaskKind>("kind", maskKindNames)) {
    case MaskKind::Gradient:
        result.shape = GradientMask{reader.oneOf<GradientMask::Shape>("shape", gradientNames),
                                    readTriple(reader, "start"),
                                    readTriple(reader, "end"),
                                    reader.number("opacityAtStart", 0, 1),
                                    reader.number("opacityAtEnd", 0, 1),
                                    reader.oneOf<MaskEasing>("easing", easingNames)};
        keep(reader, place,
             {"kind", "enabled", "inverted", "shape", "start", "end", "opacityAtStart", "opacityAtEnd",
              "easing"});
        break;
    case MaskKind::Noise:
        result.shape = NoiseMask{reader.number("cellSize", smallestPositive, largest),
                                 reader.unsignedInteger("seed"),
                                 reader.number("threshold", 0, 1),
                                 reader.number("softness", 0, 1),
                                 reader.number("low", 0, 1),
                                 reader.number("high", 0, 1)};
        keep(reader, place,
             {"kind", "enabled", "inverted", "cellSize", "seed", "threshold", "softness", "low", "high"});
        break;
    case MaskKind::Texture:
        result.shape = texture(reader);
        keep(reader, place,
             {"kind", "enabled", "inverted", "placement", "width", "height", "depth", "values"});
        break;
    case MaskKind::Strokes:
        result.shape = StrokeMask{LayerId{std::int32_t(reader.integer("layer", 0, INT32_MAX))},
                                  reader.boolean("inside")};
        keep(reader, place, {"kind", "enabled", "inverted", "layer", "inside"});
        break;
    }
    return result;
}

LayerProperties PropertyJsonReader::properties(const JsonReader &reader, const std::string &place) const
{
    LayerProperties result;
    result.visible = reader.boolean("visible");
    result.opacity = reader.number("opacity", 0, 1);
    result.blendMode = reader.oneOf<BlendMode>("blend", blendModeNames());
    if (reader.has("colour"))
        result.colour = readTriple(reader, "colour").cast<float>();
    forEach(reader, "masks", [&](const JsonReader &each, std::size_t i, std::size_t count) {
        result.masks.push_back(mask(each, listPlace(place, "mask", i, count)));
    });
    keep(reader, place, {"visible", "opacity", "blend", "colour", "masks"});
    return result;
}

std::vector<PlacementKey> PropertyJsonReader::keys(const JsonReader &owner, std::string_view key,
                                                   const std::string &place) const
{
    std::vector<PlacementKey> result;
    forEach(owner, key, [&](const JsonReader &reader, std::size_t i, std::size_t count) {
        result.push_back({reader.number("timeSeconds", -largest, largest), readPlacement(reader),
                          reader.oneOf<KeyInterpolation>("interpolation", interpolationNames)});
        keep(reader, listPlace(place, "key", i, count), {"timeSeconds", "placement", "interpolation"});
    });
    return result;
}

} // namespace ductus
