#include "doodling/tracking/patch.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double nearness = 1.2;       // places: width of the weight
constexpr float mostDifferent = 40.0f; // of a place: beyond it is another thing, however different

template <typename Visit>
void forPlaces(const Visit &visit)
{
    std::size_t i = 0;
    for (int y = -Patch::reach; y <= Patch::reach; ++y)
        for (int x = -Patch::reach; x <= Patch::reach; ++x)
            visit(i++, x, y);
}

std::array<float, 25> placeWeights()
{
    std::array<float, 25> weights{};
    forPlaces([&](std::size_t i, int x, int y) {
        weights[i] = float(std::exp(-(x * x + y * y) / (2.0 * nearness * nearness)));
    });
    return weights;
}

} // namespace

Patch patchAt(const SmallPicture &picture, const Vec2 &pixel)
{
    Patch patch;
    forPlaces([&](std::size_t i, int x, int y) {
        patch.colours[i] = picture.labAt(pixel + Patch::step * Vec2(x, y));
    });
    return patch;
}

double differenceAt(const SmallPicture &picture, const Vec2 &pixel, const Patch &patch)
{
    static const std::array<float, 25> weights = placeWeights();
    float sum = 0.0f, all = 0.0f;
    forPlaces([&](std::size_t i, int x, int y) {
        const Eigen::Vector3f d = picture.labAt(pixel + Patch::step * Vec2(x, y)) - patch.colours[i];
        // Light changes where colour does not.
        const float difference =
            std::sqrt(0.5f * d.x() * d.x() + 2.0f * d.y() * d.y() + 2.0f * d.z() * d.z());
        sum += weights[i] * std::min(difference, mostDifferent);
        all += weights[i];
    });
    return sum / all;
}

} // namespace ductus
