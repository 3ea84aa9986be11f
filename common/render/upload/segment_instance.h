// Segments of strokes as they lie on the graphics card: half the size of SegmentData, in the element's own
// space, so that moving an element uploads its placement and nothing else.
#pragma once

#include "painting/coverage/section.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ductus {

struct SegmentInstance
{
    std::array<float, 3> a;
    float radiusA;
    std::array<float, 3> b;
    float radiusB;
    std::array<std::int16_t, 4> u; // signed fractions of 32767; w: section
    std::array<std::int16_t, 4> v; // w: caps
    std::array<std::int16_t, 4> clipA;
    std::array<std::int16_t, 4> clipB;
    std::array<std::uint16_t, 4> colourA; // halves, linear RGB and opacity
    std::array<std::uint16_t, 4> colourB;
    std::uint32_t element; // row of the element table
};
static_assert(sizeof(SegmentInstance) == 84);

/// Beside each instance of a layer with tolerance.
struct ReachInstance
{
    std::array<std::int16_t, 4> a;
    std::array<std::int16_t, 4> b;
};
static_assert(sizeof(ReachInstance) == 16);

SegmentInstance instanceOf(const SegmentData &segment, std::uint32_t element);
ReachInstance reachOf(const SegmentData &segment);

/// What drawing wants to know of an element before it is drawn; in the element's space.
struct StrokeSummary
{
    Box3 box;
    bool uniformColour = true, uniformOpacity = true;
    float leastOpacity = 1;
    std::uint32_t sections = 0; // bit s: StrokeSection s occurs
};
StrokeSummary summaryOf(const std::vector<SegmentData> &segments);

} // namespace ductus
