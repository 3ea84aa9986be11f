// ShadedMesh: what a graphics card draws, as plain arrays: positions, normals, colours, triangles. Made from
// meshes and strokes on any thread; mesh_actor.h hands it to VTK.
#pragma once

#include "geometry/triangle_mesh.h"
#include "imaging/image.h"
#include "strokes/stroke.h"

#include <cstdint>
#include <vector>

namespace ductus {

struct ShadedMesh
{
    std::vector<float> positions;        // 3 a vertex
    std::vector<float> normals;          // 3 a vertex, unit
    std::vector<std::uint8_t> colours;   // 3 a vertex
    std::vector<std::int64_t> triangles; // 3 indices each

    int vertexCount() const { return int(positions.size() / 3); }
    int triangleCount() const { return int(triangles.size() / 3); }
    bool isEmpty() const { return triangles.empty(); }
};

struct ShadingOptions
{
    double creaseAngleDegrees = 35.0; // normals are not averaged across sharper edges
    Rgba colour{201, 195, 186, 255};
    /// One a triangle, or empty; vertices are split between colours.
    std::vector<Rgba> triangleColours;
    /// One a vertex, or empty; goes before the others.
    std::vector<Rgba> vertexColours;
    /// Light that reaches each vertex, 0..1 (ambient_light.h), or empty.
    std::vector<float> vertexLight;
};

ShadedMesh shadedMesh(const TriangleMesh &mesh, const ShadingOptions &options);

/// A round tube with \a sides around a polyline, closed at both ends by a small cone. \a colours: one a
/// point, or one for all. Points that are not finite and repeated points are passed over; a lone point
/// becomes a short tube.
void appendTube(const std::vector<Vec3> &points, double radius, const std::vector<Rgba> &colours, int sides,
                ShadedMesh &mesh);

} // namespace ductus
