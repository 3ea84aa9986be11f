#include "imaging/ambiguity_colours.h"

#include <algorithm>
#include <cmath>

namespace ductus {

Rgba ambiguityColour(double value)
{
    constexpr double clear = 0.12; // below this the map says nothing
    static constexpr double stops[4][3] = {{188, 188, 190}, {236, 168, 84}, {206, 84, 96}, {92, 32, 122}};
    const double share = std::clamp((value - clear) / (1.0 - clear), 0.0, 1.0);
    const double x = 3.0 * std::sqrt(share); // a third open is already worth a look
    const int i = std::min(2, int(x));
    Rgba colour{0, 0, 0, 255};
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = std::uint8_t(std::lround(stops[i][c] + (x - i) * (stops[i + 1][c] - stops[i][c])));
    return colour;
}

} // namespace ductus
