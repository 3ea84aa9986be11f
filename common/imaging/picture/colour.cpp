#include "imaging/picture/colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ductus::picture {

namespace {

double linearFromSrgb(double s)
{
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

// Smallest linear value that rounds to each byte: an exact inverse without a power for every pixel.
std::array<double, 256> byteThresholds()
{
    std::array<double, 256> thresholds{};
    for (int i = 1; i < 256; ++i)
        thresholds[std::size_t(i)] = linearFromSrgb((i - 0.5) / 255.0);
    return thresholds;
}

std::uint8_t byteFromLinear(double linear)
{
    static const std::array<double, 256> thresholds = byteThresholds();
    const auto above = std::upper_bound(thresholds.begin() + 1, thresholds.end(), linear);
    return std::uint8_t(above - thresholds.begin() - 1);
}

} // namespace

Vec3 linearFromRgba(Rgba colour)
{
    static const std::array<double, 256> table = [] {
        std::array<double, 256> values{};
        for (std::size_t i = 0; i < 256; ++i)
            values[i] = linearFromSrgb(double(i) / 255.0);
        return values;
    }();
    return {table[colour[0]], table[colour[1]], table[colour[2]]};
}

Rgba rgbaFromLinear(const Vec3 &linear)
{
    return {byteFromLinear(linear.x()), byteFromLinear(linear.y()), byteFromLinear(linear.z()), 255};
}

} // namespace ductus::picture
