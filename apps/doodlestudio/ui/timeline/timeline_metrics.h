// Sizes of the timeline's parts, pixels.
#pragma once

namespace ductus {

inline constexpr int rulerHeight = 22;
inline constexpr int rowHeight = 44;
inline constexpr int soundHeight = 32;
inline constexpr int headerWidth = 132;

} // namespace ductus
