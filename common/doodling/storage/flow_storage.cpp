#include "doodling/storage/flow_storage.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr float stepsAPixel = 32.0f;
constexpr float zero = 32768.0f;
constexpr int mostCells = 16384; // a side

std::uint16_t packed(float pixels)
{
    return std::uint16_t(std::clamp(std::round(pixels * stepsAPixel + zero), 0.0f, 65535.0f));
}

} // namespace

StoredFlow addFlow(const FlowField &flow, BufferPacker &packer)
{
    std::vector<std::uint16_t> motions;
    std::vector<std::uint8_t> confidences;
    motions.reserve(2 * flow.motions.size());
    for (const Eigen::Vector2f &motion : flow.motions) {
        motions.push_back(packed(motion.x()));
        motions.push_back(packed(motion.y()));
    }
    for (float confidence : flow.confidences)
        confidences.push_back(std::uint8_t(std::lround(255.0f * std::clamp(confidence, 0.0f, 1.0f))));
    return {packer.add<std::uint16_t>(motions, {flow.motions.size(), 2}, "px/32"),
            packer.add<std::uint8_t>(confidences, {flow.confidences.size()})};
}

OrderedJson flowJson(const FlowField &flow, const StoredFlow &stored, const BufferPacker &packer)
{
    return {{"width", flow.width},
            {"height", flow.height},
            {"cellSize", flow.cellSize},
            {"motions", packer.reference(stored.motions).toJson()},
            {"confidences", packer.reference(stored.confidences).toJson()}};
}

FlowField flowFromJson(const JsonReader &reader, ArrayLoader &arrays)
{
    FlowField flow;
    flow.width = int(reader.integer("width", 1, mostCells));
    flow.height = int(reader.integer("height", 1, mostCells));
    flow.cellSize = reader.number("cellSize", 1.0, 64.0);
    if (reader.failed())
        return {};
    const std::vector<std::uint16_t> motions = arrays.load<std::uint16_t>(reader, "motions", 2);
    const std::vector<std::uint8_t> confidences = arrays.load<std::uint8_t>(reader, "confidences", 1);
    const std::size_t cells = std::size_t(flow.width) * std::size_t(flow.height);
    if (reader.failed())
        return {};
    if (motions.size() != 2 * cells || confidences.size() != cells) {
        reader.fail("the motion has another number of cells than width times height");
        return {};
    }
    for (std::size_t i = 0; i < cells; ++i) {
        flow.motions.emplace_back((float(motions[2 * i]) - zero) / stepsAPixel,
                                  (float(motions[2 * i + 1]) - zero) / stepsAPixel);
        flow.confidences.push_back(float(confidences[i]) / 255.0f);
    }
    return flow;
}

} // namespace ductus
