// Colours of things in synthetic clips: patches, grain of several sizes and fine lines, as photos of walls,
// cloth and grass have them. A function of the place on the thing, so a point keeps its look in every frame.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace ductus {

struct ClipTexture
{
    std::uint32_t seed = 1;
    Eigen::Vector3f colour = Eigen::Vector3f(0.5f, 0.5f, 0.5f); // 0..1
    double contrast = 1.0;                                      // 0: plain
    double patchSize = 0.25;                                    // scene units
};

/// 0..1 each; \a place in scene units.
Eigen::Vector3f colourOf(const ClipTexture &texture, double x, double y);

} // namespace ductus
