#include "painting/coverage/mask_value.h"

#include <algorithm>
#include <cmath>

namespace ductus {

namespace {

std::uint32_t mix(std::uint32_t h)
{
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= 0x846ca68bu;
    return h ^ (h >> 16);
}

/// What the lattice point gives at a place \a d away from it.
double latticeValue(std::int32_t i, std::int32_t j, std::int32_t k, std::uint32_t start, const Vec3 &d)
{
    std::uint32_t h = mix(start ^ std::uint32_t(i) * 0x85ebca6bu);
    h = mix(h ^ std::uint32_t(j) * 0xc2b2ae35u);
    h = mix(h ^ std::uint32_t(k) * 0x27d4eb2fu);
    const std::uint32_t gradient = h >> 28;
    switch (gradient) {
    case 12:
        return d.x() + d.y();
    case 13:
        return -d.x() + d.y();
    case 14:
        return -d.y() + d.z();
    case 15:
        return -d.y() - d.z();
    default:
        break;
    }
    const double first = gradient < 8 ? d.x() : d.y(), second = gradient < 4 ? d.y() : d.z();
    return (gradient & 1 ? -first : first) + (gradient & 2 ? -second : second);
}

double blend(double a, double b, double t)
{
    return a + t * (b - a);
}

} // namespace

double gradientValue(const GradientMask &mask, const Vec3 &x)
{
    const Vec3 axis = mask.end - mask.start, from = x - mask.start;
    double t = mask.shape == GradientMask::Shape::Linear ? from.dot(axis) / axis.squaredNorm()
                                                         : from.norm() / axis.norm();
    t = std::clamp(t, 0.0, 1.0);
    if (mask.easing == MaskEasing::Smooth)
        t = t * t * (3 - 2 * t);
    return blend(mask.opacityAtStart, mask.opacityAtEnd, t);
}

double latticeNoise(const Vec3 &p, std::uint64_t seed)
{
    const std::uint32_t start = std::uint32_t(seed) ^ (std::uint32_t(seed >> 32) * 0x9e3779b9u);
    // Beyond what 32 bits count the pattern stands still rather than overflow.
    const Vec3 bounded = p.cwiseMax(-2e9).cwiseMin(2e9);
    const Vec3 base = bounded.array().floor(), f = bounded - base;
    const Vec3 w = f.array().cube() * (f.array() * (f.array() * 6 - 15) + 10);
    const auto i = std::int32_t(base[0]), j = std::int32_t(base[1]), k = std::int32_t(base[2]);
    const auto corner = [&](int di, int dj, int dk) {
        return latticeValue(i + di, j + dj, k + dk, start, f - Vec3(di, dj, dk));
    };
    const auto row = [&](int dj, int dk) { return blend(corner(0, dj, dk), corner(1, dj, dk), w[0]); };
    const double n = blend(blend(row(0, 0), row(1, 0), w[1]), blend(row(0, 1), row(1, 1), w[1]), w[2]);
    return std::clamp(0.5 + 0.6 * n, 0.0, 1.0);
}

double noiseValue(const NoiseMask &mask, const Vec3 &x)
{
    const double n = latticeNoise(x / mask.cellSize, mask.seed);
    const double t = mask.softness > 0 ? std::clamp((n - mask.threshold) / mask.softness + 0.5, 0.0, 1.0)
                                       : double(n >= mask.threshold);
    return blend(mask.low, mask.high, t);
}

double textureValue(const TextureMask &mask, const Vec3 &x)
{
    const Vec3 inCube = mask.placement.matrix().inverse() * x;
    const std::array<int, 3> size{mask.width, mask.height, mask.depth};
    std::array<int, 3> low, high;
    Vec3 t;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double last = size[axis] - 1;
        const double cell = std::clamp(inCube[Eigen::Index(axis)] * size[axis] - 0.5, 0.0, last);
        low[axis] = int(cell);
        high[axis] = std::min(low[axis] + 1, size[axis] - 1);
        t[Eigen::Index(axis)] = cell - low[axis];
    }
    const auto value = [&](int i, int j, int k) {
        return (*mask.values)[(std::size_t(k) * std::size_t(mask.height) + std::size_t(j)) *
                                  std::size_t(mask.width) +
                              std::size_t(i)] /
               255.0;
    };
    const auto row = [&](int j, int k) { return blend(value(low[0], j, k), value(high[0], j, k), t[0]); };
    return blend(blend(row(low[1], low[2]), row(high[1], low[2]), t[1]),
                 blend(row(low[1], high[2]), row(high[1], high[2]), t[1]), t[2]);
}

double maskValue(const Mask &mask, const Vec3 &x, bool strokeCovers)
{
    if (!mask.enabled)
        return 1;
    double value = 0;
    if (const auto *gradient = std::get_if<GradientMask>(&mask.shape))
        value = gradientValue(*gradient, x);
    else if (const auto *noise = std::get_if<NoiseMask>(&mask.shape))
        value = noiseValue(*noise, x);
    else if (const auto *texture = std::get_if<TextureMask>(&mask.shape))
        value = textureValue(*texture, x);
    else
        value = strokeCovers == std::get<StrokeMask>(mask.shape).inside ? 1 : 0;
    return mask.inverted ? 1 - value : value;
}

} // namespace ductus
