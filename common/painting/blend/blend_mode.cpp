#include "painting/blend/blend_mode.h"

namespace ductus {

namespace {

constexpr std::array<std::string_view, blendModeCount> names{
    "normal",    "multiply",     "screen",      "overlay",    "add",        "darken",
    "lighten",   "colour-dodge", "colour-burn", "hard-light", "soft-light", "difference",
    "exclusion", "hue",          "saturation",  "colour",     "luminosity"};

} // namespace

std::string_view blendModeName(BlendMode mode)
{
    return names[std::size_t(mode)];
}

std::optional<BlendMode> blendModeOf(std::string_view name)
{
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name)
            return BlendMode(i);
    return std::nullopt;
}

} // namespace ductus
