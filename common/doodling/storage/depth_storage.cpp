#include "doodling/storage/depth_storage.h"

#include <algorithm>

namespace ductus {

namespace {

constexpr int mostCells = 16384; // a side
constexpr double largest = 1e12;

DepthMap depthFromJson(const JsonReader &reader, ArrayLoader &arrays)
{
    DepthMap map;
    map.width = int(reader.integer("width", 1, mostCells));
    map.height = int(reader.integer("height", 1, mostCells));
    map.cellSize = reader.number("cellSize", 1.0, 64.0);
    map.mostDisparity = reader.number("mostDisparity", 1.0 / largest, largest);
    if (reader.failed())
        return {};
    std::vector<std::uint16_t> disparities = arrays.load<std::uint16_t>(reader, "disparities", 1);
    if (reader.has("objects"))
        map.objects = arrays.load<std::uint8_t>(reader, "objects", 1);
    if (reader.failed())
        return {};
    const std::size_t cells = std::size_t(map.width) * std::size_t(map.height);
    if (disparities.size() != cells || (!map.objects.empty() && map.objects.size() != cells)) {
        reader.fail("the depth has another number of cells than width times height");
        return {};
    }
    for (std::uint16_t &disparity : disparities)
        disparity = std::max<std::uint16_t>(disparity, 1); // depths are finite
    map.disparities = std::move(disparities);
    return map;
}

} // namespace

StoredDepths addDepths(const Shot &shot, BufferPacker &packer)
{
    StoredDepths stored;
    for (const DepthMap &map : shot.depths) {
        stored.disparities.push_back(
            packer.add<std::uint16_t>(map.disparities, {std::uint64_t(map.disparities.size())}, "1/65535"));
        stored.objects.push_back(
            map.objects.empty() ? BufferPacker::Handle()
                                : packer.add<std::uint8_t>(map.objects, {std::uint64_t(map.objects.size())}));
    }
    return stored;
}

void writeDepths(const Shot &shot, const StoredDepths &stored, const BufferPacker &packer, OrderedJson &json)
{
    if (shot.depths.empty())
        return;
    OrderedJson depths = OrderedJson::array();
    for (std::size_t t = 0; t < shot.depths.size(); ++t) {
        const DepthMap &map = shot.depths[t];
        OrderedJson depth = {{"width", map.width},
                             {"height", map.height},
                             {"cellSize", map.cellSize},
                             {"mostDisparity", map.mostDisparity},
                             {"disparities", packer.reference(stored.disparities[t]).toJson()}};
        if (!map.objects.empty())
            depth["objects"] = packer.reference(stored.objects[t]).toJson();
        depths.push_back(std::move(depth));
    }
    json["depths"] = std::move(depths);
}

void readDepths(const JsonReader &reader, ArrayLoader &arrays, int frameCount, Shot &shot)
{
    if (!reader.has("depths"))
        return;
    for (const JsonReader &depth : reader.elements("depths", std::size_t(frameCount)))
        if (!reader.failed())
            shot.depths.push_back(depthFromJson(depth, arrays));
    if (!reader.failed() && !shot.depths.empty() && shot.depths.size() != std::size_t(frameCount))
        reader.fail("there is depth of another number of frames than the clip has");
}

} // namespace ductus
