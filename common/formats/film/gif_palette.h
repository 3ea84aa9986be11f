// 256 colours for a picture, as GIF wants them.
#pragma once

#include "imaging/image.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ductus {

/// Up to 255 colours and one that is transparent (the last index).
class GifPalette
{
public:
    static constexpr int transparent = 255;

    /// The colours of \a image grouped by cutting the group of greatest scatter in two, then moved to the
    /// middle of what is nearest to them [median cut, Heckbert 1982, with variances; k-means].
    static GifPalette of(const Image &image);

    /// Mean squared distance (8 bit levels) of the pixels of \a image to their nearest colours.
    double error(const Image &image) const;

    /// An index a pixel. Colours between two of the palette are dithered by a fixed pattern, which does not
    /// swim from frame to frame as error diffusion does. Alpha below one half is transparent.
    std::vector<std::uint8_t> indices(const Image &image);

    /// Packed 0xAARRGGBB, 256 of them.
    const std::array<std::uint32_t, 256> &colours() const { return mColours; }

private:
    int nearest(int r, int g, int b) const;
    int nearestCached(int r, int g, int b);

    std::array<std::uint32_t, 256> mColours{};
    int mCount = 0;
    std::vector<std::int16_t> mCache; // by 6 bits a channel, -1: not asked for yet
};

} // namespace ductus
