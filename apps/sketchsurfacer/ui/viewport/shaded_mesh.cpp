#include "sketchsurfacer/ui/viewport/shaded_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ductus {

namespace {

// A vertex as drawn: one mesh vertex becomes several where creases or colours meet in it.
struct Corner
{
    int triangle = 0;
    int slot = 0; // 0..2
    Vec3 normal = Vec3::Zero();
    Rgba colour = {};
};

void addVertex(const Vec3 &position, const Vec3 &normal, Rgba colour, ShadedMesh &mesh)
{
    for (int axis = 0; axis < 3; ++axis) {
        mesh.positions.push_back(float(position[axis]));
        mesh.normals.push_back(float(normal[axis]));
        mesh.colours.push_back(colour[std::size_t(axis)]);
    }
}

Rgba dimmed(Rgba colour, float light)
{
    for (int channel = 0; channel < 3; ++channel)
        colour[std::size_t(channel)] = std::uint8_t(std::lround(float(colour[std::size_t(channel)]) * light));
    return colour;
}

Rgba colourOf(int triangle, int vertex, const ShadingOptions &options)
{
    Rgba colour = options.colour;
    if (!options.vertexColours.empty())
        colour = options.vertexColours[std::size_t(vertex)];
    else if (!options.triangleColours.empty())
        colour = options.triangleColours[std::size_t(triangle)];
    return options.vertexLight.empty() ? colour : dimmed(colour, options.vertexLight[std::size_t(vertex)]);
}

// Any unit vector across \a direction.
Vec3 perpendicular(const Vec3 &direction)
{
    const Vec3 axis = std::abs(direction.x()) < 0.6 ? Vec3::UnitX() : Vec3::UnitY();
    return direction.cross(axis).normalized();
}

// Points apart by more than \a step, with their colours.
std::vector<Vec3> distinctPoints(const std::vector<Vec3> &points, double step, std::vector<Rgba> &colours)
{
    const std::vector<Rgba> given = std::move(colours);
    colours.clear();
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite() || (!kept.empty() && (points[i] - kept.back()).norm() <= step))
            continue;
        kept.push_back(points[i]);
        colours.push_back(given[given.size() == points.size() ? i : 0]);
    }
    return kept;
}

} // namespace

ShadedMesh shadedMesh(const TriangleMesh &mesh, const ShadingOptions &options)
{
    std::vector<Vec3> areas(mesh.triangles.size()), units(mesh.triangles.size());
    std::vector<std::vector<Corner>> corners(mesh.vertices.size());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        areas[std::size_t(t)] = mesh.areaVector(t);
        const double length = areas[std::size_t(t)].norm();
        units[std::size_t(t)] = length > 0.0 ? Vec3(areas[std::size_t(t)] / length) : Vec3(Vec3::UnitZ());
        for (int k = 0; k < 3; ++k)
            corners[std::size_t(mesh.triangles[std::size_t(t)][std::size_t(k)])].push_back(
                {t, k, Vec3::Zero(), {}});
    }
    const double cosine = std::cos(options.creaseAngleDegrees * std::numbers::pi / 180.0);

    ShadedMesh shaded;
    shaded.triangles.resize(3 * mesh.triangles.size());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        std::vector<Corner> &around = corners[std::size_t(v)];
        for (Corner &corner : around) {
            for (const Corner &other : around)
                if (units[std::size_t(corner.triangle)].dot(units[std::size_t(other.triangle)]) >= cosine)
                    corner.normal += areas[std::size_t(other.triangle)];
            corner.normal = corner.normal.norm() > 0.0 ? Vec3(corner.normal.normalized())
                                                       : units[std::size_t(corner.triangle)];
            corner.colour = colourOf(corner.triangle, v, options);
        }
        for (std::size_t i = 0; i < around.size(); ++i) {
            Corner &corner = around[i];
            std::int64_t index = -1;
            for (std::size_t j = 0; j < i && index < 0; ++j)
                if (around[j].colour == corner.colour && around[j].normal.dot(corner.normal) > 0.9995)
                    index = shaded.triangles[std::size_t(3 * around[j].triangle + around[j].slot)];
            if (index < 0) {
                index = shaded.vertexCount();
                addVertex(mesh.vertices[std::size_t(v)], corner.normal, corner.colour, shaded);
            }
            shaded.triangles[std::size_t(3 * corner.triangle + corner.slot)] = index;
        }
    }
    return shaded;
}

void appendTube(const std::vector<Vec3> &points, double radius, const std::vector<Rgba> &colours, int sides,
                ShadedMesh &mesh)
{
    std::vector<Rgba> colourOfPoint = colours;
    std::vector<Vec3> line = distinctPoints(points, 0.15 * radius, colourOfPoint);
    if (line.empty())
        return;
    if (line.size() == 1) {
        line.push_back(line.front() + Vec3(radius, 0, 0));
        colourOfPoint.push_back(colourOfPoint.front());
    }

    const auto tangentAt = [&](std::size_t i) {
        const Vec3 t = line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0];
        return t.norm() > 0.0 ? Vec3(t.normalized()) : Vec3(Vec3::UnitX());
    };
    Vec3 across = perpendicular(tangentAt(0));
    const std::int64_t first = mesh.vertexCount();
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec3 tangent = tangentAt(i);
        const Vec3 carried = across - across.dot(tangent) * tangent; // parallel transport, up to projection
        across = carried.norm() > 1e-6 ? Vec3(carried.normalized()) : perpendicular(tangent);
        const Vec3 second = tangent.cross(across);
        for (int s = 0; s < sides; ++s) {
            const double angle = 2.0 * std::numbers::pi * s / sides;
            const Vec3 normal = std::cos(angle) * across + std::sin(angle) * second;
            addVertex(line[i] + radius * normal, normal, colourOfPoint[i], mesh);
        }
    }
    const auto ring = [&](std::size_t i, int s) { return first + std::int64_t(i) * sides + s % sides; };
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        for (int s = 0; s < sides; ++s) {
            const std::int64_t corners[6] = {ring(i, s), ring(i, s + 1),     ring(i + 1, s + 1),
                                             ring(i, s), ring(i + 1, s + 1), ring(i + 1, s)};
            mesh.triangles.insert(mesh.triangles.end(), corners, corners + 6);
        }
    for (const bool atStart : {true, false}) {
        const std::size_t i = atStart ? 0 : line.size() - 1;
        const Vec3 outwards = atStart ? Vec3(-tangentAt(i)) : tangentAt(i);
        const std::int64_t tip = mesh.vertexCount();
        addVertex(line[i] + 0.7 * radius * outwards, outwards, colourOfPoint[i], mesh);
        for (int s = 0; s < sides; ++s) {
            const std::int64_t a = ring(i, s), b = ring(i, s + 1);
            const std::int64_t corners[3] = {tip, atStart ? b : a, atStart ? a : b};
            mesh.triangles.insert(mesh.triangles.end(), corners, corners + 3);
        }
    }
}

} // namespace ductus
