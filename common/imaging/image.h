// Image: 8-bit RGBA, rows top to bottom, straight (not premultiplied) alpha.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace ductus {

using Rgba = std::array<std::uint8_t, 4>;

struct Image
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels; // width * height * 4

    Image() = default;
    Image(int w, int h, Rgba fill = {0, 0, 0, 0});

    Rgba at(int x, int y) const;
    void set(int x, int y, Rgba colour);
};

} // namespace ductus
