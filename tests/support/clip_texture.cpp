#include "support/clip_texture.h"

#include <cmath>

namespace ductus {

namespace {

// Uniform in 0..1, a function of a lattice point.
float lattice(int x, int y, std::uint32_t seed)
{
    std::uint32_t h = std::uint32_t(x) * 0x8da6b343u ^ std::uint32_t(y) * 0xd8163841u ^ seed * 0xcb1ab31fu;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return float(h >> 8) / float(1u << 24);
}

float smoothNoise(double x, double y, std::uint32_t seed)
{
    const double fx = std::floor(x), fy = std::floor(y);
    const int i = int(fx), j = int(fy);
    float u = float(x - fx), v = float(y - fy);
    u = u * u * (3.0f - 2.0f * u);
    v = v * v * (3.0f - 2.0f * v);
    const float a = lattice(i, j, seed), b = lattice(i + 1, j, seed);
    const float c = lattice(i, j + 1, seed), d = lattice(i + 1, j + 1, seed);
    return (a + (b - a) * u) * (1.0f - v) + (c + (d - c) * u) * v;
}

// The number of the patch a place is in: cells around scattered middles, with edges a corner detector sees.
std::uint32_t patchAt(double x, double y, std::uint32_t seed)
{
    const int i = int(std::floor(x)), j = int(std::floor(y));
    double nearest = 1e9;
    std::uint32_t patch = 0;
    for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di) {
            const double mx = i + di + lattice(i + di, j + dj, seed + 11);
            const double my = j + dj + lattice(i + di, j + dj, seed + 23);
            const double distance = (mx - x) * (mx - x) + (my - y) * (my - y);
            if (distance < nearest) {
                nearest = distance;
                patch = std::uint32_t((i + di) * 7919 + (j + dj) * 104729);
            }
        }
    return patch;
}

} // namespace

Eigen::Vector3f colourOf(const ClipTexture &texture, double x, double y)
{
    const double u = x / texture.patchSize, v = y / texture.patchSize;
    const std::uint32_t patch = patchAt(u, v, texture.seed);
    Eigen::Vector3f colour = texture.colour;
    const float contrast = float(texture.contrast);
    for (int c = 0; c < 3; ++c)
        colour[c] += contrast * 0.3f * (lattice(int(patch), c, texture.seed + 5) - 0.5f);
    float grain = 0.0f, weight = 0.22f;
    double scale = 0.7;
    for (std::uint32_t octave = 0; octave < 4; ++octave) {
        grain += weight * (smoothNoise(u * scale, v * scale, texture.seed + 100 + octave) - 0.5f);
        weight *= 0.85f;
        scale *= 2.3;
    }
    const Eigen::Vector3f shaded = colour + Eigen::Vector3f::Constant(contrast * grain);
    return shaded.cwiseMax(0.0f).cwiseMin(1.0f);
}

} // namespace ductus
