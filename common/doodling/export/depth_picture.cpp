#include "doodling/export/depth_picture.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace ductus {

DisparityRange disparityRange(const Shot &shot)
{
    std::vector<double> samples;
    for (int t = 0; t < shot.frameCount(); t += std::max(1, shot.frameCount() / 16))
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 32; ++x)
                samples.push_back(
                    1.0 / shot.depthAt(t, Vec2((x + 0.5) * shot.width / 32, (y + 0.5) * shot.height / 24)));
    if (samples.empty())
        return {};
    std::sort(samples.begin(), samples.end());
    const std::size_t end = samples.size() / 100;
    const double dark = samples[end], light = samples[samples.size() - 1 - end];
    // All at one depth: middle grey.
    return light > dark * (1.0 + 1e-6) ? DisparityRange{dark, light} : DisparityRange{0.0, 2.0 * dark};
}

Image depthPicture(const Shot &shot, int frame, const DisparityRange &range, int width, int height)
{
    Image image(width, height, {0, 0, 0, 255});
    parallelFor(
        0, std::size_t(height),
        [&](std::size_t y) {
            for (int x = 0; x < width; ++x) {
                const Vec2 pixel((x + 0.5) * shot.width / width, (double(y) + 0.5) * shot.height / height);
                const double share =
                    (1.0 / shot.depthAt(frame, pixel) - range.dark) / (range.light - range.dark);
                const std::uint8_t grey = std::uint8_t(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
                image.set(x, int(y), {grey, grey, grey, 255});
            }
        },
        16);
    return image;
}

} // namespace ductus
