#include "doodling/reconstruction/long_flow.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr int framesWithAllGaps = 240; // more of them have the longer gaps from some frames only

} // namespace

MotionAt CompactFlow::at(const Eigen::Vector2d &pixel) const
{
    const GridPlace place(pixel, cellSize, width, height);
    double x = 0.0, y = 0.0, confidence = 0.0;
    for (int i = 0; i < 4; ++i) {
        const std::size_t cell = place.cells[i];
        x += place.shares[i] * motions[2 * cell];
        y += place.shares[i] * motions[2 * cell + 1];
        confidence += place.shares[i] * confidences[cell];
    }
    return {Eigen::Vector2d(x, y) / double(stepsAPixel), confidence / 255.0};
}

CompactFlow::CompactFlow(const FlowField &flow)
    : width(flow.width), height(flow.height), cellSize(flow.cellSize)
{
    std::vector<std::int16_t> steps;
    std::vector<std::uint8_t> trusts;
    steps.reserve(2 * flow.motions.size());
    trusts.reserve(flow.confidences.size());
    const auto packed = [](float pixels) {
        return std::int16_t(std::clamp(std::round(pixels * stepsAPixel), -32767.0f, 32767.0f));
    };
    for (const Eigen::Vector2f &motion : flow.motions) {
        steps.push_back(packed(motion.x()));
        steps.push_back(packed(motion.y()));
    }
    for (float confidence : flow.confidences)
        trusts.push_back(std::uint8_t(std::lround(255.0f * std::clamp(confidence, 0.0f, 1.0f))));
    motions = std::move(steps);
    confidences = std::move(trusts);
}

std::size_t CompactFlow::cellAt(const Eigen::Vector2d &pixel) const
{
    const int x = std::clamp(int(pixel.x() / cellSize), 0, width - 1);
    const int y = std::clamp(int(pixel.y() / cellSize), 0, height - 1);
    return std::size_t(y) * std::size_t(width) + std::size_t(x);
}

CompactFlow compacted(const FlowField &flow)
{
    return flow;
}

FlowField expanded(const CompactFlow &flow)
{
    FlowField field{flow.width, flow.height, flow.cellSize, {}, {}};
    for (std::size_t cell = 0; cell < flow.cellCount(); ++cell) {
        field.motions.push_back(flow.cellMotion(cell));
        field.confidences.push_back(flow.cellConfidence(cell));
    }
    return field;
}

std::vector<int> longGapsTo(int frame, int frameCount)
{
    std::vector<int> gaps;
    for (int gap : longGaps) {
        const int from = frame - gap;
        if (from >= 0 && (frameCount <= framesWithAllGaps || from % (gap / 2) == 0))
            gaps.push_back(gap);
    }
    return gaps;
}

} // namespace ductus
