// PropertyJsonWriter: masks, properties and keys as JSON.
#include "painting/storage/painting_names.h"
#include "painting/storage/property_json.h"
#include "painting/storage/unknown_places.h"

namespace ductus {

OrderedJson tripleJson(const Vec3 &v)
{
    return {v.x(), v.y(), v.z()};
}

OrderedJson tripleJson(const Eigen::Vector3f &v)
{
    return {double(v.x()), double(v.y()), double(v.z())};
}

OrderedJson rotationJson(const Eigen::Quaterniond &q)
{
    return {q.x(), q.y(), q.z(), q.w()};
}

OrderedJson placementJson(const Placement &placement)
{
    return {{"rotation", rotationJson(placement.rotation)},
            {"scale", placement.scale},
            {"mirrored", placement.mirrored},
            {"translation", tripleJson(placement.translation)}};
}

OrderedJson PropertyJsonWriter::kept(OrderedJson object, const std::string &place) const
{
    if (!mUnknown)
        return object;
    if (const auto found = mUnknown->find(place); found != mUnknown->end())
        addUnknown(object, found->second);
    return object;
}

OrderedJson PropertyJsonWriter::shapeJson(const GradientMask &mask) const
{
    return {{"shape", wordOf(gradientNames, mask.shape)},
            {"start", tripleJson(mask.start)},
            {"end", tripleJson(mask.end)},
            {"opacityAtStart", mask.opacityAtStart},
            {"opacityAtEnd", mask.opacityAtEnd},
            {"easing", wordOf(easingNames, mask.easing)}};
}

OrderedJson PropertyJsonWriter::shapeJson(const NoiseMask &mask) const
{
    return {{"cellSize", mask.cellSize}, {"seed", mask.seed}, {"threshold", mask.threshold},
            {"softness", mask.softness}, {"low", mask.low},   {"high", mask.high}};
}

OrderedJson PropertyJsonWriter::shapeJson(const TextureMask &mask) const
{
    return {{"placement", placementJson(mask.placement)},
            {"width", mask.width},
            {"height", mask.height},
            {"depth", mask.depth},
            {"values", mBytes(*mask.values)}};
}

OrderedJson PropertyJsonWriter::shapeJson(const StrokeMask &mask) const
{
    return {{"layer", mask.layer.value}, {"inside", mask.inside}};
}

OrderedJson PropertyJsonWriter::mask(const Mask &mask) const
{
    OrderedJson json = {{"kind", wordOf(maskKindNames, MaskKind(mask.shape.index()))},
                        {"enabled", mask.enabled},
                        {"inverted", mask.inverted}};
    json.update(std::visit([this](const auto &shape) { return shapeJson(shape); }, mask.shape));
    return json;
}

OrderedJson PropertyJsonWriter::properties(const LayerProperties &properties, const std::string &place) const
{
    OrderedJson json = {{"visible", properties.visible},
                        {"opacity", properties.opacity},
                        {"blend", blendModeName(properties.blendMode)}};
    if (properties.colour)
        json["colour"] = tripleJson(*properties.colour);
    json["masks"] = OrderedJson::array();
    for (std::size_t i = 0; i < properties.masks.size(); ++i)
        json["masks"].push_back(
            kept(mask(properties.masks[i]), listPlace(place, "mask", i, properties.masks.size())));
    return kept(std::move(json), place);
}

OrderedJson PropertyJsonWriter::keys(const std::vector<PlacementKey> &keys, const std::string &place) const
{
    OrderedJson json = OrderedJson::array();
    for (std::size_t i = 0; i < keys.size(); ++i)
        json.push_back(kept({{"timeSeconds", keys[i].timeSeconds},
                             {"placement", placementJson(keys[i].placement)},
                             {"interpolation", wordOf(interpolationNames, keys[i].interpolation)}},
                            listPlace(place, "key", i, keys.size())));
    return json;
}

} // namespace ductus
