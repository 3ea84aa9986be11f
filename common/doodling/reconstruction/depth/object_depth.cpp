#include "doodling/reconstruction/depth/object_depth.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double feetShare = 0.2; // of the object's height
constexpr int window = 10;        // frames to each side
constexpr double inFront = 1.03;  // of the ground below: never behind it

struct Extent
{
    int top = 1 << 20, bottom = -1;
};

float quantile(std::vector<float> &values, double share)
{
    const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

} // namespace

ObjectDisparities contactDisparities(const std::vector<std::uint8_t> &objects,
                                     const std::vector<float> &background, int width, int height)
{
    std::array<Extent, 256> extents;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            Extent &extent = extents[objects[std::size_t(y) * std::size_t(width) + std::size_t(x)]];
            extent.top = std::min(extent.top, y);
            extent.bottom = std::max(extent.bottom, y);
        }
    std::array<std::vector<float>, 256> below;
    for (int x = 0; x < width; ++x)
        for (int y = 0; y < height; ++y) {
            const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
            const int object = objects[i];
            const Extent &extent = extents[std::size_t(object)];
            const bool isLowest = y + 1 == height || objects[i + std::size_t(width)] != object;
            if (object == 0 || !isLowest || y < extent.bottom - feetShare * (extent.bottom - extent.top))
                continue;
            const int ground = std::min(height - 1, y + 1);
            below[std::size_t(object)].push_back(
                background[std::size_t(ground) * std::size_t(width) + std::size_t(x)]);
        }
    ObjectDisparities disparities{};
    for (std::size_t object = 1; object < below.size(); ++object)
        if (!below[object].empty())
            disparities[object] = float(inFront) * quantile(below[object], 0.5);
    return disparities;
}

void smoothOverTime(std::vector<ObjectDisparities> &frames)
{
    const std::vector<ObjectDisparities> raw = frames;
    const int count = int(raw.size());
    for (std::size_t object = 1; object < 256; ++object)
        for (int t = 0; t < count; ++t) {
            if (raw[std::size_t(t)][object] <= 0.0f)
                continue;
            std::vector<float> around;
            for (int s = std::max(0, t - window); s <= std::min(count - 1, t + window); ++s)
                if (raw[std::size_t(s)][object] > 0.0f)
                    around.push_back(std::log(raw[std::size_t(s)][object]));
            const float middle = quantile(around, 0.5);
            double sum = 0.0, weights = 0.0;
            for (float value : around) {
                const double weight = 1.0 / (1.0 + 40.0 * double((value - middle) * (value - middle)));
                sum += weight * double(value);
                weights += weight;
            }
            frames[std::size_t(t)][object] = float(std::exp(sum / weights));
        }
}

} // namespace ductus
