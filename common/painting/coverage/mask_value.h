// What masks say at a point. Everything but stroke masks, which need the strokes (layer_solid.h). Written so
// that a shader gives the same numbers: noise uses 32-bit integers only.
#pragma once

#include "geometry/triangle_mesh.h"
#include "painting/scene/mask.h"

namespace ductus {

/// Linear: t = dot(x - start, end - start) / |end - start|^2; spherical: t = |x - start| / |end - start|.
/// t is cut to 0..1, eased (Smooth: 3 t^2 - 2 t^3), then mixes opacityAtStart and opacityAtEnd.
double gradientValue(const GradientMask &mask, const Vec3 &x);

/// n = latticeNoise(x / cellSize, seed), then low + (high - low) clamp((n - threshold) / softness + 1/2, 0,
/// 1); without softness a step at n >= threshold.
double noiseValue(const NoiseMask &mask, const Vec3 &x);

/// Gradient noise [Perlin 2002], 0..1: clamp(0.5 + 0.6 n, 0, 1). n mixes, by w = f^3 (6 f^2 - 15 f + 10) of
/// the fractional parts f of p, x first, then y, then z, what the 8 lattice points (i, j, k) around p give:
/// dot(gradient, p - (i, j, k)). The gradient is number h >> 28 of the sixteen
///     (+-1, +-1, 0) for 0..3, (+-1, 0, +-1) for 4..7, (0, +-1, +-1) for 8..11, bit 0 set: the first of the
///     two is negative, bit 1 set: the second is; 12..15 are (1, 1, 0), (-1, 1, 0), (0, -1, 1), (0, -1, -1)
/// and the hash of (i, j, k), all uint32 with wrap-around:
///     h = seedLow ^ (seedHigh * 0x9e3779b9); h = mix(h ^ i * 0x85ebca6b); h = mix(h ^ j * 0xc2b2ae35);
///     h = mix(h ^ k * 0x27d4eb2f)
///     mix(h): h ^= h >> 16; h *= 0x7feb352d; h ^= h >> 15; h *= 0x846ca68b; h ^= h >> 16
double latticeNoise(const Vec3 &p, std::uint64_t seed);

/// Trilinear between cell centres, constant beyond the block's border.
double textureValue(const TextureMask &mask, const Vec3 &x);

/// The share of a mask that is not a stroke mask, inversion included, 0..1; 1 if it is not enabled.
/// \a strokeCovers answers for stroke masks: whether any stroke of the layer covers the point.
double maskValue(const Mask &mask, const Vec3 &x, bool strokeCovers);

} // namespace ductus
