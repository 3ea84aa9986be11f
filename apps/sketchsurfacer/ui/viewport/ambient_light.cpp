#include "sketchsurfacer/ui/viewport/ambient_light.h"

#include "base/parallel.h"

#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr int rayCount = 40;

// Directions around +z, denser where they count more (cosine weighting), on a golden-angle spiral.
std::vector<Vec3> hemisphere()
{
    std::vector<Vec3> directions;
    for (int i = 0; i < rayCount; ++i) {
        const double r = std::sqrt((i + 0.5) / rayCount);
        const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        directions.emplace_back(r * std::cos(angle), r * std::sin(angle),
                                std::sqrt(std::max(0.0, 1.0 - r * r)));
    }
    return directions;
}

} // namespace

std::vector<float> ambientLight(const TriangleMesh &mesh, const RayTree &tree, double reach, float darkest,
                                const JobControl &control)
{
    const std::vector<Vec3> normals = vertexNormals(mesh);
    const std::vector<Vec3> directions = hemisphere();
    std::vector<float> light(mesh.vertices.size(), 1.0f);
    parallelChunks(mesh.vertices.size(), 256, [&](std::size_t begin, std::size_t end) {
        if (control.isCancelled())
            return;
        for (std::size_t v = begin; v < end; ++v) {
            const Vec3 n = normals[v];
            if (n.isZero())
                continue;
            const Vec3 u = n.cross(std::abs(n.x()) < 0.6 ? Vec3::UnitX() : Vec3::UnitY()).normalized();
            const Vec3 w = n.cross(u);
            const Vec3 origin = mesh.vertices[v] + 0.01 * reach * n;
            int blocked = 0;
            for (const Vec3 &d : directions)
                blocked += tree.isBlocked(origin, d.x() * u + d.y() * w + d.z() * n, 0.0, reach);
            light[v] = 1.0f - (1.0f - darkest) * float(blocked) / rayCount;
        }
    });
    return control.isCancelled() ? std::vector<float>() : light;
}

} // namespace ductus
