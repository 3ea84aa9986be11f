#include "imaging/image.h"

#include <algorithm>

namespace ductus {

Image::Image(int w, int h, Rgba fill) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h) * 4)
{
    for (std::size_t i = 0; i < pixels.size(); i += 4)
        std::copy(fill.begin(), fill.end(), pixels.begin() + std::ptrdiff_t(i));
}

Rgba Image::at(int x, int y) const
{
    const std::size_t i = (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4;
    return {pixels[i], pixels[i + 1], pixels[i + 2], pixels[i + 3]};
}

void Image::set(int x, int y, Rgba colour)
{
    const std::size_t i = (std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4;
    std::copy(colour.begin(), colour.end(), pixels.begin() + std::ptrdiff_t(i));
}

} // namespace ductus
