// Strokes as flat ribbons that turn to the eye: what they look like where they are a few pixels wide, for a
// fraction of what exact ones cost. Used while the view turns.
#pragma once

#include "painting/scene/element.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ductus {

/// Of a triangle strip; two follow each other at each place of the centreline.
struct RibbonVertex
{
    std::array<float, 3> position;      // of the centreline, element's space
    float halfWidth;                    // < 0 on the other side
    std::array<std::int16_t, 4> along;  // signed fractions of 32767; w: section
    std::array<std::int16_t, 4> normal; // signed fractions
    std::array<std::uint8_t, 4> colour; // sRGB, opacity
    std::uint32_t element;              // row of the element table
};
static_assert(sizeof(RibbonVertex) == 40);

/// Appends the strip of a stroke, its first and last vertex doubled so that strips can follow each other in
/// one draw. The stroke's bends are followed by at most \a most places; nothing for strokes without length.
void appendRibbon(const StrokeShape &stroke, std::uint32_t element, std::size_t most,
                  std::vector<RibbonVertex> &vertices);

} // namespace ductus
