#include "doodling/storage/flow_storage.h"

namespace ductus {

namespace {

constexpr int zero = 32768;
constexpr int mostCells = 16384; // a side

} // namespace

StoredFlow addFlow(const CompactFlow &flow, BufferPacker &packer)
{
    std::vector<std::uint16_t> motions;
    motions.reserve(flow.motions.size());
    for (std::int16_t steps : flow.motions)
        motions.push_back(std::uint16_t(int(steps) + zero));
    return {packer.add<std::uint16_t>(motions, {flow.cellCount(), 2}, "px/32"),
            packer.add<std::uint8_t>(flow.confidences, {flow.cellCount()})};
}

OrderedJson flowJson(const CompactFlow &flow, const StoredFlow &stored, const BufferPacker &packer)
{
    return {{"width", flow.width},
            {"height", flow.height},
            {"cellSize", flow.cellSize},
            {"motions", packer.reference(stored.motions).toJson()},
            {"confidences", packer.reference(stored.confidences).toJson()}};
}

CompactFlow flowFromJson(const JsonReader &reader, ArrayLoader &arrays)
{
    CompactFlow flow;
    flow.width = int(reader.integer("width", 1, mostCells));
    flow.height = int(reader.integer("height", 1, mostCells));
    flow.cellSize = reader.number("cellSize", 1.0, 64.0);
    if (reader.failed())
        return {};
    const std::vector<std::uint16_t> motions = arrays.load<std::uint16_t>(reader, "motions", 2);
    std::vector<std::uint8_t> confidences = arrays.load<std::uint8_t>(reader, "confidences", 1);
    const std::size_t cells = std::size_t(flow.width) * std::size_t(flow.height);
    if (reader.failed())
        return {};
    if (motions.size() != 2 * cells || confidences.size() != cells) {
        reader.fail("the motion has another number of cells than width times height");
        return {};
    }
    std::vector<std::int16_t> steps;
    steps.reserve(motions.size());
    for (std::uint16_t motion : motions)
        steps.push_back(std::int16_t(int(motion) - zero));
    flow.motions = std::move(steps);
    flow.confidences = std::move(confidences);
    return flow;
}

} // namespace ductus
