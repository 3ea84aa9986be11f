#include "surfacing/proxy/proxy_quality.h"

#include "geometry/mesh_topology.h"
#include "geometry/nearest.h"

#include <algorithm>
#include <cstdio>

namespace ductus {

namespace {

std::string percent(double share)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.2f %%", 100.0 * share);
    return text;
}

} // namespace

std::optional<std::string> proxyFault(const TriangleMesh &candidate, const TriangleMesh &wrap,
                                      const std::vector<Vec3> &strokePoints, const ProxyQualityLimits &limits)
{
    if (candidate.triangleCount() < 20)
        return "the smooth surface is empty";
    const NearestOnMesh nearest(candidate);
    std::vector<double> distances;
    for (const Vec3 &p : strokePoints)
        distances.push_back(nearest.nearest(p).distance);
    std::sort(distances.begin(), distances.end());
    const double median = distances[distances.size() / 2], p95 = distances[distances.size() * 95 / 100];
    if (median > limits.medianDistance || p95 > limits.p95Distance)
        return "the smooth surface misses the strokes (median " + percent(median) + ", 95th percentile " +
               percent(p95) + " of the diagonal)";
    if (surfaceArea(candidate) > limits.areaRatio * surfaceArea(wrap))
        return "the smooth surface folds beyond the strokes";
    return std::nullopt;
}

TriangleMesh withoutStrayComponents(const TriangleMesh &mesh, const std::vector<Vec3> &strokePoints)
{
    int count = 0;
    const std::vector<int> component = triangleComponents(MeshTopology(mesh), &count);
    if (count < 2)
        return mesh;
    const NearestOnMesh nearest(mesh);
    std::vector<int> hits(std::size_t(count), 0);
    for (const Vec3 &p : strokePoints)
        ++hits[std::size_t(component[std::size_t(nearest.nearest(p).triangle)])];
    TriangleMesh kept = mesh;
    kept.triangles.clear();
    for (int t = 0; t < mesh.triangleCount(); ++t)
        if (hits[std::size_t(component[std::size_t(t)])] * 33 >= int(strokePoints.size()))
            kept.triangles.push_back(mesh.triangles[std::size_t(t)]);
    return compacted(kept);
}

} // namespace ductus
