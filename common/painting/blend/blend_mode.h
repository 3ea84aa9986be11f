// The blend modes of layers and their stable names in files and on the command line.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace ductus {

/// As in W3C Compositing and Blending Level 1, sections 10.1 and 10.2; Add is "plus-lighter" of Level 2 on
/// colours.
enum class BlendMode {
    Normal,
    Multiply,
    Screen,
    Overlay,
    Add,
    Darken,
    Lighten,
    ColourDodge,
    ColourBurn,
    HardLight,
    SoftLight,
    Difference,
    Exclusion,
    Hue,
    Saturation,
    Colour,
    Luminosity,
};

inline constexpr int blendModeCount = 17;

/// "multiply", "colour-dodge", ...
std::string_view blendModeName(BlendMode mode);
std::optional<BlendMode> blendModeOf(std::string_view name);

/// In which numbers colours are mixed: sRGB-encoded, as painters know it from 2D programs, or linear light.
enum class BlendSpace { Encoded, Linear };

} // namespace ductus
