// Triangles of meshes as they lie on the graphics card, three of these each, in the element's own space.
#pragma once

#include "painting/scene/element.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ductus {

struct MeshVertex
{
    std::array<float, 3> position;
    std::array<std::uint16_t, 4> colour; // halves, linear RGB and 1
    std::uint32_t element;               // row of the element table
};
static_assert(sizeof(MeshVertex) == 24);

std::vector<MeshVertex> verticesOf(const MeshShape &shape, std::uint32_t element);

/// The mean of the vertices' colours, linear RGB: what a mesh colours with in an appearance layer.
Eigen::Vector3f meanColourOf(const MeshShape &shape);

} // namespace ductus
