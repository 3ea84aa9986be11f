#include "geometry/inspection/print_check.h"

#include "geometry/mesh_topology.h"

#include <cmath>

namespace ductus {

namespace {

// The first of \a samples (shortest first) that is no spot of noise.
std::optional<ThicknessSample> shortestThatCounts(const std::vector<ThicknessSample> &samples, double area)
{
    double covered = 0.0;
    for (const ThicknessSample &sample : samples) {
        covered += sample.area;
        if (covered >= PrintCheck::leastShare * area)
            return sample;
    }
    return std::nullopt;
}

Vec3 placeOf(const TriangleMesh &mesh, const TrianglePair &pair)
{
    // The smaller triangle is nearer to where they meet.
    const bool first = mesh.areaVector(pair.first).norm() < mesh.areaVector(pair.second).norm();
    return mesh.centroid(first ? pair.first : pair.second);
}

void findCrossings(const TriangleMesh &mesh, const MeshTopology &topology, PrintCheck &check)
{
    const std::vector<int> shell = triangleComponents(topology, &check.shells);
    for (const TrianglePair &pair : selfIntersections(mesh, PrintCheck::mostCrossings)) {
        const bool isOne = shell[std::size_t(pair.first)] == shell[std::size_t(pair.second)];
        (isOne ? check.crossings : check.overlaps).push_back(pair);
        std::optional<Vec3> &place = isOne ? check.crossing : check.overlap;
        if (!place)
            place = placeOf(mesh, pair);
    }
}

} // namespace

Result<PrintCheck> checkForPrint(const TriangleMesh &mesh, const JobControl &control)
{
    constexpr const char *attempted = "Checking the print";
    control.progress(0.0, attempted);
    PrintCheck check;
    check.box = boundingBox(mesh.vertices);
    check.area = surfaceArea(mesh);
    const MeshTopology topology(mesh);
    const ManifoldReport manifold = manifoldReport(mesh);
    check.isWatertight = manifold.isClosed() && !mesh.isEmpty();
    check.borderEdges = manifold.borderEdges;
    for (std::size_t e = 0; e < topology.edges.size() && !check.border; ++e)
        if (topology.isBorder(int(e)))
            check.border = 0.5 * (mesh.vertices[std::size_t(topology.edges[e].v0)] +
                                  mesh.vertices[std::size_t(topology.edges[e].v1)]);
    if (control.isCancelled())
        return cancelledError(attempted);
    findCrossings(mesh, topology, check);
    control.progress(0.4, attempted);
    if (!check.isWatertight)
        return check;
    check.volume = std::abs(signedVolume(mesh));
    Result<Thickness> thickness = thicknessOf(mesh, ThicknessOptions(), control.part(0.4, 1.0));
    if (!thickness)
        return thickness.error();
    check.thickness = std::move(*thickness);
    check.thinnestWall = shortestThatCounts(check.thickness.walls, check.area);
    check.narrowestGap = shortestThatCounts(check.thickness.gaps, check.area);
    return check;
}

} // namespace ductus
