// Masks: each gives a number 0..1 at every point of space; a layer's opacity is multiplied by all of them in
// order.
#pragma once

#include "painting/scene/ids.h"
#include "painting/scene/placement.h"

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace ductus {

enum class MaskEasing { Linear, Smooth };

/// From \a opacityAtStart at \a start to \a opacityAtEnd at \a end, constant beyond. Linear: along the line.
/// Spherical: start is the centre, end a point of the sphere.
struct GradientMask
{
    enum class Shape { Linear, Spherical };
    Shape shape = Shape::Linear;
    Eigen::Vector3d start = Eigen::Vector3d::Zero(); // scene units
    Eigen::Vector3d end = Eigen::Vector3d::UnitY();  // not the same as start
    double opacityAtStart = 1;                       // 0..1
    double opacityAtEnd = 0;                         // 0..1
    MaskEasing easing = MaskEasing::Linear;
};

/// Procedural noise: low below the threshold, high above, a ramp of \a softness between.
struct NoiseMask
{
    double cellSize = 1; // scene units, > 0
    std::uint64_t seed = 1;
    double threshold = 0.5; // 0..1
    double softness = 0.1;  // 0..1
    double low = 0;         // 0..1
    double high = 1;        // 0..1
};

/// A block of opacities, interpolated between cell centres, constant beyond its border.
struct TextureMask
{
    Placement placement; // scene from the unit cube
    int width = 0, height = 0, depth = 0;
    std::shared_ptr<const std::vector<std::uint8_t>> values; // x fastest, then y; 255 is opaque
};

/// Shows the layer only inside (or outside) the strokes of another layer.
struct StrokeMask
{
    LayerId layer;
    bool inside = true;
};

struct Mask
{
    bool enabled = true;
    bool inverted = false;
    std::variant<GradientMask, NoiseMask, TextureMask, StrokeMask> shape;
};

} // namespace ductus
