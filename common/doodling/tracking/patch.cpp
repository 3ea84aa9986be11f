#include "doodling/tracking/patch.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

constexpr double nearness = 1.2;       // places: width of the weight
constexpr float mostDifferent = 40.0f; // of a place: beyond it is another thing, however different

} // namespace

Patch patchAt(const SmallPicture &picture, const Vec2 &pixel)
{
    Patch patch;
    for (std::size_t i = 0; i < Patch::count; ++i) {
        const Vec2 offset = Patch::offsetOf(i);
        patch.colours[i] = picture.labAt(pixel + offset);
        patch.weights[i] =
            float(std::exp(-(offset / Patch::step).squaredNorm() / (2.0 * nearness * nearness)));
    }
    return patch;
}

double differenceAt(const SmallPicture &picture, const Vec2 &pixel, const Patch &patch,
                    const Eigen::Matrix2d &warp)
{
    float sum = 0.0f, all = 0.0f;
    for (std::size_t i = 0; i < Patch::count; ++i) {
        const Eigen::Vector3f d = picture.labAt(pixel + warp * Patch::offsetOf(i)) - patch.colours[i];
        // Light changes where colour does not.
        const float difference =
            std::sqrt(0.5f * d.x() * d.x() + 2.0f * d.y() * d.y() + 2.0f * d.z() * d.z());
        sum += patch.weights[i] * std::min(difference, mostDifferent);
        all += patch.weights[i];
    }
    return sum / all;
}

} // namespace ductus
