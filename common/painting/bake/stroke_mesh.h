// Triangles for the skin of a stroke, for programs that know only meshes.
#pragma once

#include "painting/coverage/section.h"

#include <span>

namespace ductus {

/// A vertex knows where on its stroke it lies, for the colour.
struct SkinVertex
{
    Vec3 position = Vec3::Zero();
    std::uint32_t segment = 0; // place in the span
};

struct SkinMesh
{
    std::vector<SkinVertex> vertices;
    std::vector<Triangle> triangles;
};

/// The skin of one stroke's segments: rings of vertices across it no further than \a edge (scene units) apart
/// along the stroke and around it (round and elliptic rings have 6 to 96 vertices, however fine), closed at
/// both ends: round ones by half balls, flat ones by a lid. Ribbons are sheets. Faces look outwards.
SkinMesh strokeMesh(std::span<const SegmentData> stroke, double edge);

} // namespace ductus
