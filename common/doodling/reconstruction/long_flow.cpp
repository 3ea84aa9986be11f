#include "doodling/reconstruction/long_flow.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr float stepsAPixel = 32.0f;
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
    return {Eigen::Vector2d(x, y) / stepsAPixel, confidence / 255.0};
}

CompactFlow compacted(const FlowField &flow)
{
    CompactFlow compact{flow.width, flow.height, flow.cellSize, {}, {}};
    compact.motions.reserve(2 * flow.motions.size());
    compact.confidences.reserve(flow.confidences.size());
    const auto packed = [](float pixels) {
        return std::int16_t(std::clamp(std::round(pixels * stepsAPixel), -32767.0f, 32767.0f));
    };
    for (const Eigen::Vector2f &motion : flow.motions) {
        compact.motions.push_back(packed(motion.x()));
        compact.motions.push_back(packed(motion.y()));
    }
    for (float confidence : flow.confidences)
        compact.confidences.push_back(std::uint8_t(std::lround(255.0f * std::clamp(confidence, 0.0f, 1.0f))));
    return compact;
}

FlowField expanded(const CompactFlow &flow)
{
    FlowField field{flow.width, flow.height, flow.cellSize, {}, {}};
    for (std::size_t cell = 0; cell < flow.confidences.size(); ++cell) {
        field.motions.emplace_back(float(flow.motions[2 * cell]) / stepsAPixel,
                                   float(flow.motions[2 * cell + 1]) / stepsAPixel);
        field.confidences.push_back(float(flow.confidences[cell]) / 255.0f);
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
