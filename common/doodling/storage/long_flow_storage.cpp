#include "doodling/storage/long_flow_storage.h"

#include <iterator>

namespace ductus {

namespace {

constexpr int mostCells = 65536; // a side
constexpr int longestGap = 1024; // frames

SmallPicture pictureFromJson(const JsonReader &reader, ArrayLoader &arrays)
{
    SmallPicture picture;
    picture.width = int(reader.integer("width", 1, mostCells));
    picture.height = int(reader.integer("height", 1, mostCells));
    picture.colourWidth = int(reader.integer("colourWidth", 1, mostCells));
    picture.colourHeight = int(reader.integer("colourHeight", 1, mostCells));
    if (reader.failed())
        return {};
    picture.lightness = arrays.load<std::uint8_t>(reader, "lightness", 1);
    picture.colours = arrays.load<std::uint8_t>(reader, "colours", 2);
    const std::size_t pixels = std::size_t(picture.width) * std::size_t(picture.height);
    const std::size_t cells = std::size_t(picture.colourWidth) * std::size_t(picture.colourHeight);
    if (!reader.failed() && (picture.lightness.size() != pixels || picture.colours.size() != 2 * cells))
        reader.fail("the picture has another number of pixels than width times height");
    return picture;
}

} // namespace

StoredLongFlows addLongFlows(const Shot &shot, BufferPacker &packer)
{
    StoredLongFlows stored;
    for (const auto &[span, flows] : shot.longFlows) {
        stored.forward.push_back(addFlow(flows.forward, packer));
        stored.backward.push_back(addFlow(flows.backward, packer));
    }
    for (const SmallPicture &picture : shot.pictures) {
        stored.lightness.push_back(
            packer.add<std::uint8_t>(picture.lightness, {std::uint64_t(picture.lightness.size())}));
        stored.colours.push_back(
            packer.add<std::uint8_t>(picture.colours, {std::uint64_t(picture.colours.size() / 2), 2}));
    }
    return stored;
}

void writeLongFlows(const Shot &shot, const StoredLongFlows &stored, const BufferPacker &packer,
                    OrderedJson &json)
{
    OrderedJson flows = OrderedJson::array(), pictures = OrderedJson::array();
    std::size_t i = 0;
    for (const auto &[span, pair] : shot.longFlows) {
        flows.push_back({{"first", span.first},
                         {"gap", span.second},
                         {"forward", flowJson(pair.forward, stored.forward[i], packer)},
                         {"backward", flowJson(pair.backward, stored.backward[i], packer)}});
        ++i;
    }
    for (std::size_t t = 0; t < shot.pictures.size(); ++t)
        pictures.push_back({{"width", shot.pictures[t].width},
                            {"height", shot.pictures[t].height},
                            {"colourWidth", shot.pictures[t].colourWidth},
                            {"colourHeight", shot.pictures[t].colourHeight},
                            {"lightness", packer.reference(stored.lightness[t]).toJson()},
                            {"colours", packer.reference(stored.colours[t]).toJson()}});
    json["longFlows"] = std::move(flows);
    json["pictures"] = std::move(pictures);
}

void readLongFlows(const JsonReader &reader, ArrayLoader &arrays, int frameCount, Shot &shot)
{
    const std::size_t most = std::size_t(frameCount) * std::size(longGaps);
    if (reader.has("longFlows"))
        for (const JsonReader &flow : reader.elements("longFlows", most)) {
            const int first = int(flow.integer("first", 0, frameCount - 1));
            const int gap = int(flow.integer("gap", 2, longestGap));
            if (!reader.failed() && first + gap >= frameCount)
                flow.fail("it goes on beyond the clip");
            if (reader.failed())
                return;
            CompactFlow forward = flowFromJson(flow.member("forward"), arrays);
            CompactFlow backward = flowFromJson(flow.member("backward"), arrays);
            if (!reader.failed())
                shot.longFlows[{first, gap}] = {std::move(forward), std::move(backward)};
        }
    if (!reader.has("pictures"))
        return;
    for (const JsonReader &picture : reader.elements("pictures", std::size_t(frameCount)))
        if (!reader.failed())
            shot.pictures.push_back(pictureFromJson(picture, arrays));
    if (!reader.failed() && !shot.pictures.empty() && shot.pictures.size() != std::size_t(frameCount))
        reader.fail("there are small pictures of another number of frames than the clip has");
}

} // namespace ductus
